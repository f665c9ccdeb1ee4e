#include <hybridfusion/core/options.hpp>

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion::detail {
namespace {

template <class Number>
bool parse_number(std::string_view text, Number& value) {
  Number parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  value = parsed;
  return true;
}

}  // namespace

bool is_choice(std::string_view choices, std::string_view value) {
  if (choices.empty()) return true;
  while (true) {
    const std::size_t bar = choices.find('|');
    if (choices.substr(0, bar) == value) return true;
    if (bar == std::string_view::npos) return false;
    choices.remove_prefix(bar + 1);
  }
}

std::string to_text(double value) {
  return fmt::format("{}", value);
}

bool from_text(std::string_view text, double& value) {
  double parsed = 0.0;
  if (!parse_number(text, parsed) || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

bool from_text(std::string_view text, int& value) {
  return parse_number(text, value);
}

bool from_text(std::string_view text, bool& value) {
  if (text != "true" && text != "false") return false;
  value = text == "true";
  return true;
}

bool from_text(std::string_view text, std::string& value) {
  value = text;
  return true;
}

std::string range_text(const FieldInfo& info) {
  if (!info.choices.empty()) {
    std::string text(info.choices);
    for (std::size_t bar = text.find('|'); bar != std::string::npos; bar = text.find('|', bar)) {
      text.replace(bar, 1, ", ");
    }
    return text;
  }
  const bool has_min = std::isfinite(info.min);
  const bool has_max = std::isfinite(info.max);
  if (has_min && has_max) return fmt::format("{} .. {}", info.min, info.max);
  if (has_min) return fmt::format(">= {}", info.min);
  if (has_max) return fmt::format("<= {}", info.max);
  return {};
}

}  // namespace hybridfusion::detail
