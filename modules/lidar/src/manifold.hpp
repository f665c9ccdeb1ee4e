#pragma once

/// @file
/// Rotations SO(3) and directions S2 as used by the error-state filter. Notation of Sola et al., "A
/// micro Lie theory for state estimation in robotics" (2018); perturbations act on the right.

#include <Eigen/Geometry>

namespace hybridfusion {

/// [v]x with [v]x w = v x w.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& v);

/// Rotation by `phi` (axis times angle [rad]).
[[nodiscard]] Eigen::Matrix3d so3_exp(const Eigen::Vector3d& phi);
/// Inverse of so3_exp with angle in [0, pi].
[[nodiscard]] Eigen::Vector3d so3_log(const Eigen::Matrix3d& rotation);

/// Jr(phi): Exp(phi + d) = Exp(phi) Exp(Jr(phi) d) to first order.
[[nodiscard]] Eigen::Matrix3d so3_right_jacobian(const Eigen::Vector3d& phi);

using S2Basis = Eigen::Matrix<double, 3, 2>;

/// Orthonormal basis of the plane at right angles to `direction` (any length but 0).
[[nodiscard]] S2Basis s2_basis(const Eigen::Vector3d& direction);
/// `direction` turned by Exp(B(direction) u); the length is kept.
[[nodiscard]] Eigen::Vector3d s2_plus(const Eigen::Vector3d& direction, const Eigen::Vector2d& u);
/// The u with s2_plus(from, u) parallel to `to`; a half turn about the first axis when opposite.
[[nodiscard]] Eigen::Vector2d s2_minus(const Eigen::Vector3d& to, const Eigen::Vector3d& from);
/// d s2_plus(direction, u) / du.
[[nodiscard]] S2Basis s2_plus_jacobian(const Eigen::Vector3d& direction, const Eigen::Vector2d& u);
/// d s2_minus(to, direction) / d to at to = direction.
[[nodiscard]] Eigen::Matrix<double, 2, 3> s2_minus_jacobian(const Eigen::Vector3d& direction);

}  // namespace hybridfusion
