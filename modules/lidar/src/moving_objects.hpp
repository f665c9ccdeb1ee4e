#pragma once

#include "dense_map.hpp"

namespace hybridfusion {

/// Drops voxels that were hit briefly and that rays of other scans went through: what moved. Looks
/// at most at 40 scans near `center_m` and not farther than 25 m. @returns how many were dropped;
/// kIo.
[[nodiscard]] Expected<std::size_t> drop_moving(const DenseMapOptions& options,
                                                const ScanStore& store,
                                                const Eigen::Vector2d& center_m,
                                                DenseMap& map);

}  // namespace hybridfusion
