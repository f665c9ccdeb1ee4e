#pragma once

#include <cmath>

#include <Eigen/Geometry>

namespace hybridfusion {

/// skew(a) b = a x b.
[[nodiscard]] inline Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// Exponential map of a rotation vector [rad].
[[nodiscard]] inline Eigen::Quaterniond rotation_exp(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const double half = 0.5 * angle;
  // sin(x)/x to fourth order below 1e-4, where the quotient loses digits.
  const double factor = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(half);
  q.vec() = factor * rotation_vector;
  return q;
}

}  // namespace hybridfusion
