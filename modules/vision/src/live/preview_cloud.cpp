#include "live/preview_cloud.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <utility>

namespace hybridfusion {

void PreviewCloud::merge(const PhotoPoints& points, const Rigid3& enu_from_camera) {
  constexpr double kReach = 1 << 19;  // voxel_key() counts to twice that
  for (std::size_t i = 0; i < points.in_camera.size(); ++i) {
    const Eigen::Vector3d point = enu_from_camera * points.in_camera[i].cast<double>();
    if (!((point / voxel_m_).cwiseAbs().maxCoeff() < kReach)) continue;
    const VoxelIndex index = (point / voxel_m_).array().floor().cast<int>();
    VoxelSums& sums = voxels_[voxel_key(index)];
    sums.offset += (point - voxel_m_ * index.cast<double>()).cast<float>();
    sums.count_color(points.colors[i]);
  }
}

void PreviewCloud::rebuild() {
  while (true) {
    voxels_ = {};
    for (std::size_t k = 0; k < photos_.size(); ++k) merge(photos_[k], poses_[k]);
    if (voxels_.size() <= max_points_) return;
    voxel_m_ *= 2.0;
  }
}

void PreviewCloud::add(PhotoPoints points, const Rigid3& enu_from_camera) {
  HF_CHECK(has_voxel());
  HF_CHECK(points.in_camera.size() == points.colors.size());
  photos_.push_back(std::move(points));
  poses_.push_back(enu_from_camera);
  merge(photos_.back(), enu_from_camera);
  if (voxels_.size() > max_points_) rebuild();
}

void PreviewCloud::move(const std::vector<Rigid3>& poses, double scale) {
  HF_CHECK(poses.size() == photos_.size());
  poses_ = poses;
  for (PhotoPoints& photo : photos_) {
    for (Eigen::Vector3f& point : photo.in_camera) point *= static_cast<float>(scale);
  }
  rebuild();
}

PointCloud PreviewCloud::cloud() const {
  std::vector<const VoxelSums*> sorted;
  sorted.reserve(voxels_.size());
  voxels_.for_each([&](const VoxelSums& sums) { sorted.push_back(&sums); });
  std::ranges::sort(sorted, {}, &VoxelSums::key);
  PointCloud cloud;
  for (const VoxelSums* sums : sorted) {
    const auto count = static_cast<float>(sums->count);
    const Eigen::Vector3d corner = voxel_m_ * voxel_of_key(sums->key).cast<double>();
    cloud.points.emplace_back((corner + (sums->offset / count).cast<double>()).cast<float>());
    cloud.colors.push_back(sums->mean_color());
    cloud.confidences.push_back(count);
  }
  return cloud;
}

}  // namespace hybridfusion
