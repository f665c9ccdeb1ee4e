#pragma once

#include "depth_map.hpp"
#include "voxel_table.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

namespace hybridfusion {

/// Merges checked depth maps in voxels: positions by inverse variance, mean colour, `confidences` =
/// number of depths.
class DepthFusion {
 public:
  explicit DepthFusion(double voxel_m);
  void add(const DepthMap& map);
  /// The cloud of all maps, in ascending voxel order: see choose_voxels() on those of fewer than
  /// `min_depths` depths and one_sheet() on positions, normals and sigmas. Leaves the object empty.
  [[nodiscard]] PointCloud finish(int min_depths, const RunContext& ctx);

 private:
  double voxel_m_;
  VoxelTable voxels_ = {};
};

}  // namespace hybridfusion
