#pragma once

#include <hybridfusion/core/time.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace hybridfusion {

/// "1777674600.050000" to nanoseconds without going through a double; further digits are dropped.
/// Falls back to a double for forms such as 1.7e9.
[[nodiscard]] std::optional<Timestamp> parse_seconds(std::string_view text);

/// Seconds as parse_seconds, or a whole number of milli-, micro- or nanoseconds since the epoch,
/// told by its size.
[[nodiscard]] std::optional<Timestamp> parse_stamp(std::string_view text);

/// Seconds with nine decimals, exact.
[[nodiscard]] std::string seconds_text(Timestamp time);

}  // namespace hybridfusion
