#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Essential matrices E with second^T E first = 0 for five pairs of normalised image points
/// (Stewenius, Engels and Nister, "Recent developments on direct relative orientation", 2006).
/// @returns Up to 10 real solutions, unit Frobenius norm; none for degenerate points.
[[nodiscard]] std::vector<Eigen::Matrix3d> essential_from_five_points(
    const std::array<Eigen::Vector2d, 5>& first, const std::array<Eigen::Vector2d, 5>& second);

}  // namespace hybridfusion
