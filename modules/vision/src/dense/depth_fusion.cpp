#include "depth_fusion.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/normals.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <utility>

namespace hybridfusion {
namespace {

/// The cloud with `normals` holding the direction to the photos until real normals replace them.
PointCloud cloud_of(const VoxelTable& voxels, double voxel_m, int min_count) {
  std::vector<const VoxelSums*> kept;
  voxels.for_each([&](const VoxelSums& sums) {
    if (sums.count >= min_count) kept.push_back(&sums);
  });
  std::ranges::sort(kept, {}, &VoxelSums::key);
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
    const Eigen::Vector3f color = sums->color / static_cast<float>(sums->count);
    Rgb8 rgb{};
    for (int c = 0; c < 3; ++c) {
      rgb[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::lround(color[c]));
    }
    cloud.colors.push_back(rgb);
    // Depths of one photo share its matching error: count their weights once per photo at most.
    cloud.sigmas_m.push_back(std::sqrt(static_cast<float>(sums->count) / sums->weight));
    cloud.confidences.push_back(static_cast<float>(sums->count));
  }
  return cloud;
}

/// Normals from the neighbourhoods, turned towards the photos. Points whose mean distance to their
/// neighbours is far above the average are specks in the air and left out.
PointCloud with_normals(PointCloud cloud, const RunContext& ctx) {
  constexpr std::size_t kNeighbors = 16;
  constexpr double kMaxSigmas = 3.0;
  const KdTree tree(cloud.points);
  std::vector<float> distance(cloud.size(), 0.0F);
  parallel_for(ctx, cloud.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(cloud.points[i], kNeighbors + 1, neighbors);
      for (const Neighbor& n : neighbors) distance[i] += std::sqrt(n.squared_distance_m2);
      const Eigen::Vector3f normal = shape_of(cloud.points, neighbors).normal;
      cloud.normals[i] = normal.dot(cloud.normals[i]) < 0.0F ? Eigen::Vector3f(-normal) : normal;
    }
  });
  if (cloud.size() <= kNeighbors) return cloud;
  double sum = 0.0;
  double squares = 0.0;
  for (const double d : distance) {
    sum += d;
    squares += d * d;
  }
  const auto count = static_cast<double>(distance.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] <= mean + kMaxSigmas * deviation) kept.push_back(i);
  }
  return kept.size() == cloud.size() ? cloud : select(cloud, kept);
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
      const VoxelIndex index = voxel_of(point.cast<float>(), voxel_m_);
      const float sigma = map.sigma_m.at(x, y);
      const float weight = 1.0F / (sigma * sigma);
      VoxelSums& sums = voxels_[voxel_key(index)];
      sums.weight += weight;
      sums.offset += weight * (point - voxel_m_ * index.cast<double>()).cast<float>();
      sums.towards_photo -= ray.normalized().cast<float>();
      const Rgb8& rgb = map.rgb.at(x, y);
      sums.color += Eigen::Vector3f(rgb[0], rgb[1], rgb[2]);
      ++sums.count;
    }
  }
}

PointCloud DepthFusion::finish(int min_depths, const RunContext& ctx) {
  PointCloud cloud = cloud_of(voxels_, voxel_m_, min_depths);
  voxels_ = {};  // as large as the cloud
  return with_normals(std::move(cloud), ctx);
}

}  // namespace hybridfusion
