#include "thinned_cloud.hpp"

#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/io/ply.hpp>

#include <unordered_set>

#include <fmt/format.h>

namespace hybridfusion {

Expected<PointCloud> read_thinned(const std::filesystem::path& path,
                                  double voxel_m,
                                  const Sim3& target_from_cloud,
                                  const RunContext& ctx) {
  constexpr std::size_t kBatchPoints = 262144;
  PointCloud thinned;
  std::unordered_set<std::uint64_t> seen;
  auto read = read_ply_batches(path, kBatchPoints, [&](PointCloud&& batch) -> Expected<void> {
    if (ctx.stopped()) {
      return fail(ErrorCode::kCancelled, fmt::format("stopped while reading {}", path.string()));
    }
    const PointCloud moved = transformed(target_from_cloud, std::move(batch));
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (seen.insert(voxel_key(voxel_of(moved.points[i], voxel_m))).second) kept.push_back(i);
    }
    thinned = concatenate(std::move(thinned), select(moved, kept));
    return {};
  });
  if (!read) return std::unexpected(read.error());
  return thinned;
}

}  // namespace hybridfusion
