#include "text.hpp"

#include <algorithm>

namespace hybridfusion {
namespace {
constexpr std::string_view kSpace = " \t\r\n\v\f";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<std::string_view> split_words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t first = text.find_first_not_of(kSpace); first != std::string_view::npos;) {
    const std::size_t last = std::min(text.find_first_of(kSpace, first), text.size());
    words.push_back(text.substr(first, last - first));
    first = text.find_first_not_of(kSpace, last);
  }
  return words;
}

std::vector<std::string_view> split_fields(std::string_view text, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = text.find(separator);
    fields.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

std::string printable(std::string_view text) {
  constexpr std::size_t kMaxLength = 60;
  std::string result(text.substr(0, kMaxLength));
  std::ranges::replace_if(
      result, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text.size() > kMaxLength ? result + "..." : result;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

}  // namespace hybridfusion
