#include "depth_fusion.hpp"

#include "cloud_sheet.hpp"
#include "voxel_choice.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>
#include <hybridfusion/geometry/voxel_range.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace hybridfusion {
namespace {

/// The cloud with `normals` holding the direction to the photos until real normals replace them.
PointCloud cloud_of(const VoxelTable& voxels, double voxel_m, int min_count) {
  const std::vector<const VoxelSums*> kept = choose_voxels(voxels, min_count);
  PointCloud cloud;
  cloud.points.reserve(kept.size());
  cloud.normals.reserve(kept.size());
  cloud.colors.reserve(kept.size());
  cloud.sigmas_m.reserve(kept.size());
  cloud.confidences.reserve(kept.size());
  for (const VoxelSums* sums : kept) {
    const Eigen::Vector3d corner = voxel_m * voxel_of_key(sums->key).cast<double>();
    cloud.points.emplace_back(
        (corner + (sums->offset / sums->weight).cast<double>()).cast<float>());
    cloud.normals.emplace_back(sums->towards_photo.stableNormalized());
    cloud.colors.push_back(sums->mean_color());
    // Depths of one photo share its matching error: count their weights once per photo at most.
    cloud.sigmas_m.push_back(std::sqrt(static_cast<float>(sums->count) / sums->weight));
    cloud.confidences.push_back(static_cast<float>(sums->count));
  }
  return cloud;
}

}  // namespace

DepthFusion::DepthFusion(double voxel_m) : voxel_m_(voxel_m) {
  HF_CHECK(voxel_m > 0.0);
}

void DepthFusion::add(const DepthMap& map) {
  const Eigen::Vector3d centre = map.enu_from_camera.translation;
  const Eigen::Matrix3d enu_from_camera = map.enu_from_camera.rotation.toRotationMatrix();
  for (int y = 0; y < map.grid.height_px; ++y) {
    for (int x = 0; x < map.grid.width_px; ++x) {
      if (!map.has_depth(x, y)) continue;
      const Eigen::Vector3d ray = enu_from_camera * ray_of(map.grid, {x, y});
      const Eigen::Vector3d point = centre + map.depth_m.at(x, y) * ray;
      if (!in_voxel_key_reach(point, voxel_m_)) continue;  // its key would be that of another place
      const VoxelIndex index = voxel_of(point.cast<float>(), voxel_m_);
      const float sigma = map.sigma_m.at(x, y);
      const float weight = 1.0F / (sigma * sigma);
      VoxelSums& sums = voxels_[voxel_key(index)];
      sums.weight += weight;
      sums.offset += weight * (point - voxel_m_ * index.cast<double>()).cast<float>();
      sums.towards_photo -= ray.normalized().cast<float>();
      sums.count_color(map.rgb.at(x, y));
    }
  }
}

PointCloud DepthFusion::finish(int min_depths, const RunContext& ctx) {
  voxels_.close();
  PointCloud cloud = cloud_of(voxels_, voxel_m_, min_depths);
  voxels_ = {};  // as large as the cloud
  return one_sheet(std::move(cloud), ctx);
}

}  // namespace hybridfusion
