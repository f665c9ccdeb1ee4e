#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Without white space at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// The words between white space.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text);
/// The fields between separators, trimmed; empty fields are kept.
[[nodiscard]] std::vector<std::string_view> split_fields(std::string_view text, char separator);
/// At most 60 characters fit for an error message; control characters become '?'.
[[nodiscard]] std::string printable(std::string_view text);
[[nodiscard]] std::string lower_case(std::string_view text);

/// The number that the whole of `text` is ("nan" and "inf" included); nothing otherwise.
template <class Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value = {};
  const char* const end = text.data() + text.size();
  const auto [stop, status] = std::from_chars(text.data(), end, value);
  if (status != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace hybridfusion
