#include "isolated_points.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <unordered_map>

namespace hybridfusion {

std::vector<std::uint32_t> supported_points(std::span<const Eigen::Vector3f> points,
                                            double cell_m,
                                            int min_points) {
  HF_CHECK(cell_m > 0.0);
  std::unordered_map<std::uint64_t, int> counts;
  for (const Eigen::Vector3f& p : points) ++counts[voxel_key(voxel_of(p, cell_m))];
  const auto count_around = [&](const VoxelIndex& cell) {
    int sum = 0;
    for (int z = -1; z <= 1; ++z) {
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          const auto found = counts.find(voxel_key(cell + VoxelIndex(x, y, z)));
          if (found != counts.end()) sum += found->second;
        }
      }
    }
    return sum;
  };
  std::unordered_map<std::uint64_t, bool> is_supported;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const VoxelIndex cell = voxel_of(points[i], cell_m);
    const auto [entry, is_new] = is_supported.try_emplace(voxel_key(cell), false);
    if (is_new) entry->second = count_around(cell) >= min_points;
    if (entry->second) kept.push_back(i);
  }
  return kept;
}

}  // namespace hybridfusion
