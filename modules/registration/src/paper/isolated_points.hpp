#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Indices (ascending) of the points that have at least `min_points` points, themselves included,
/// in the 3 x 3 x 3 cells of side `cell_m` around. Stereo mismatches float alone in the air: they
/// would fill every boundary and every shape descriptor. @pre cell_m > 0
[[nodiscard]] std::vector<std::uint32_t> supported_points(std::span<const Eigen::Vector3f> points,
                                                          double cell_m,
                                                          int min_points);

}  // namespace hybridfusion
