#pragma once

#include "voxel_table.hpp"

#include <vector>

namespace hybridfusion {

/// The voxels that become points, in ascending order of their keys: those with `min_count` depths
/// or more, and those with fewer where the photos sample a surface that thinly. There, others lie
/// beside it, and none before or behind it, seen from the photos, holds more of that surface; if
/// one does, the few depths are the noise of its sheet.
[[nodiscard]] std::vector<const VoxelSums*> choose_voxels(const VoxelTable& voxels, int min_count);

}  // namespace hybridfusion
