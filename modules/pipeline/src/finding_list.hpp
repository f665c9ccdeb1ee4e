#pragma once

#include <hybridfusion/pipeline/doctor.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// What is always the same about a finding.
struct FindingKind {
  std::string_view id;
  Severity severity;
  std::string_view meaning;
  std::string_view remedy;
};
[[nodiscard]] std::span<const FindingKind> finding_kinds();

/// Collects findings; their severity and remedy come from the table of kinds.
class FindingList {
 public:
  /// @param id  One of finding_kinds().
  void add(std::string_view id, std::string cause, const std::vector<std::string>& subjects = {});
  /// Errors first, otherwise in the order in which they were found.
  [[nodiscard]] std::vector<Finding> take();
  [[nodiscard]] bool contains(std::string_view id) const;

 private:
  std::vector<Finding> findings_ = {};
};

/// "a.jpg, b.jpg and 7 more"; control characters are replaced.
[[nodiscard]] std::string listed(std::span<const std::string> names);

}  // namespace hybridfusion
