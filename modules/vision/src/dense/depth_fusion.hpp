#pragma once

#include "depth_map.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/densify_options.hpp>

#include <span>

namespace hybridfusion {

/// Merges checked depth maps in voxels of `voxel_m`: positions by inverse variance, mean colour,
/// `confidences` = number of depths. Drops thinly supported voxels and statistical outliers;
/// normals come from the neighbourhood, turned towards the photos. Ascending voxel order.
[[nodiscard]] PointCloud fuse_depth_maps(std::span<const DepthMap> maps,
                                         double voxel_m,
                                         const DensifyOptions& options,
                                         const RunContext& ctx);

}  // namespace hybridfusion
