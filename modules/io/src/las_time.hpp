#pragma once

namespace hybridfusion {

/// Adjusted standard GPS time of LAS: seconds since 1980-01-06 without leap seconds (18 since 2017)
/// minus 1e9. 0 stands for "no time" on both sides.
inline constexpr double kLasTimeMinusUnix_s = -315964800.0 + 18.0 - 1e9;

[[nodiscard]] inline double las_time(double unix_s) {
  return unix_s == 0.0 ? 0.0 : unix_s + kLasTimeMinusUnix_s;
}

[[nodiscard]] inline double unix_time_of_las(double las_s) {
  return las_s == 0.0 ? 0.0 : las_s - kLasTimeMinusUnix_s;
}

}  // namespace hybridfusion
