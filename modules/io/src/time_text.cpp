#include "time_text.hpp"

#include "text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {

std::optional<Timestamp> parse_seconds(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view digits = negative ? text.substr(1) : text;
  const std::size_t point = digits.find('.');
  const auto whole = parse_number<std::uint64_t>(digits.substr(0, point));
  std::string fraction(point == std::string_view::npos ? "" : digits.substr(point + 1));
  const bool plain = fraction.find_first_not_of("0123456789") == std::string::npos;
  constexpr std::uint64_t kMaxSeconds = 9'000'000'000;
  if (whole && plain) {
    if (*whole > kMaxSeconds) return std::nullopt;
    fraction.resize(9, '0');
    const Timestamp time =
        std::chrono::seconds(*whole) + Timestamp(parse_number<std::int64_t>(fraction).value_or(0));
    return negative ? -time : time;
  }
  const auto value = parse_number<double>(text);
  if (!value || !(std::abs(*value) <= static_cast<double>(kMaxSeconds))) return std::nullopt;
  return from_seconds(*value);
}

std::optional<Timestamp> parse_stamp(std::string_view text) {
  const auto whole = parse_number<std::int64_t>(text);
  if (!whole) return parse_seconds(text);
  // Times since the epoch are 1e9 s today and were 0.9e9 s in 2000; each unit adds three digits.
  constexpr std::int64_t kMaxSeconds = 100'000'000'000;
  const std::int64_t magnitude = std::abs(*whole);
  if (magnitude < kMaxSeconds) return parse_seconds(text);
  if (magnitude < kMaxSeconds * 1000) return std::chrono::milliseconds(*whole);
  if (magnitude < kMaxSeconds * 1'000'000) return std::chrono::microseconds(*whole);
  return Timestamp(*whole);
}

std::string seconds_text(Timestamp time) {
  const std::int64_t ns = time.count();
  const std::uint64_t magnitude =
      ns < 0 ? 0U - static_cast<std::uint64_t>(ns) : static_cast<std::uint64_t>(ns);
  return fmt::format(
      "{}{}.{:09}", ns < 0 ? "-" : "", magnitude / 1'000'000'000U, magnitude % 1'000'000'000U);
}

}  // namespace hybridfusion
