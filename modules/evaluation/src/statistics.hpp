#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion {

/// The value with a share `q` of the others below it (nearest rank); NaN for an empty list.
template <class Value>
[[nodiscard]] double quantile(std::vector<Value> values, double q) {
  if (values.empty()) return std::nan("");
  const auto rank =
      static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return static_cast<double>(values[static_cast<std::size_t>(rank)]);
}

[[nodiscard]] inline double to_deg(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

/// Angle by which a rotation takes the z axis away from itself.
[[nodiscard]] inline double tilt_deg(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d up = rotation * Eigen::Vector3d::UnitZ();
  return to_deg(std::atan2(up.head<2>().norm(), up.z()));
}

}  // namespace hybridfusion
