#include "finding_list.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {

std::string_view to_string(Severity severity) {
  return severity == Severity::kWarning ? "warning" : "error";
}

void FindingList::add(std::string_view id,
                      std::string cause,
                      const std::vector<std::string>& subjects) {
  const auto kind = std::ranges::find(finding_kinds(), id, &FindingKind::id);
  HF_CHECK(kind != finding_kinds().end());
  findings_.push_back({.id = std::string(id),
                       .severity = kind->severity,
                       .cause = std::move(cause),
                       .remedy = std::string(kind->remedy),
                       .subjects = subjects});
}

std::vector<Finding> FindingList::take() {
  std::ranges::stable_sort(findings_, std::ranges::greater(), &Finding::severity);
  return std::exchange(findings_, {});
}

bool FindingList::contains(std::string_view id) const {
  return std::ranges::find(findings_, id, &Finding::id) != findings_.end();
}

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kMaxListed = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxListed); ++i) {
    text += (i > 0 ? ", " : "") + names[i];
  }
  if (names.size() > kMaxListed) text += fmt::format(" and {} more", names.size() - kMaxListed);
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; }, '?');
  return text;
}

std::string findings_reference() {
  std::string markdown = "| finding | severity | meaning | remedy |\n|---|---|---|---|\n";
  for (const FindingKind& kind : finding_kinds()) {
    markdown += fmt::format(
        "| `{}` | {} | {} | {} |\n", kind.id, to_string(kind.severity), kind.meaning, kind.remedy);
  }
  return markdown;
}

}  // namespace hybridfusion
