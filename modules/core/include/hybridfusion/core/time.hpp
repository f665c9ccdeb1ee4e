#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace hybridfusion {

/// Time since the UNIX epoch. Differences of timestamps are exact; seconds appear only as durations
/// inside formulas.
using Timestamp = std::chrono::nanoseconds;

[[nodiscard]] inline double to_seconds(Timestamp duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Nearest nanosecond. Absolute epochs lose about 0.2 us in a double: convert durations, not
/// epochs, where that matters.
[[nodiscard]] inline Timestamp from_seconds(double seconds) {
  return Timestamp(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

}  // namespace hybridfusion
