#pragma once

#include <hybridfusion/geometry/ground.hpp>

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// A low height of one cell: what may be ground.
struct GroundCandidate {
  std::int64_t cell_x;
  std::int64_t cell_y;
  Eigen::Vector3d point;  ///< Cell centre and percentile height [m].
};

/// One candidate for each cell of side `options.cell_m` that holds `options.min_points`, ordered by
/// cell. Points that are not finite are left out.
[[nodiscard]] std::vector<GroundCandidate> ground_candidates(
    std::span<const Eigen::Vector3f> points, const GroundOptions& options);

/// The lowest candidate of each block of side `block_m`.
[[nodiscard]] std::vector<Eigen::Vector3d> block_minima(std::span<const GroundCandidate> candidates,
                                                        double block_m);

}  // namespace hybridfusion
