#pragma once

#include <hybridfusion/registration/patch_candidates.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Mean over the LiDAR patch's neighbours of the best correlation with any neighbour of the vision
/// patch (HybridFusion III-C.3: the direction of a neighbour is not enforced, since the two grids
/// do not coincide). Neighbours without a descriptor do not count; 0 when either side has none.
[[nodiscard]] double neighbour_similarity(std::span<const std::size_t> lidar_neighbours,
                                          const PatchSignatures& lidar,
                                          std::span<const std::size_t> vision_neighbours,
                                          const PatchSignatures& vision);

/// Keeps the candidates of `lidar_patch` whose neighbourhood is at least `min_score` similar, and
/// notes the score in them. @param min_points  Smaller neighbours are left out.
[[nodiscard]] std::vector<PatchCandidate> filter_by_neighbours(
    std::size_t lidar_patch,
    std::span<const PatchCandidate> candidates,
    const PatchGrid& lidar_grid,
    const PatchSignatures& lidar,
    const PatchGrid& vision_grid,
    const PatchSignatures& vision,
    std::size_t min_points,
    double min_score);

}  // namespace hybridfusion
