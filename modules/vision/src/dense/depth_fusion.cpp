#include "depth_fusion.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/normals.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <unordered_map>

namespace hybridfusion {
namespace {

/// Weighted sums of the depths that fall into one voxel.
struct VoxelSums {
  double weight = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d towards_photo = Eigen::Vector3d::Zero();
  Eigen::Vector3d color = Eigen::Vector3d::Zero();
  int count = 0;
};

double median_depth(const DepthMap& map) {
  std::vector<float> depths;
  for (std::size_t i = 0; i < map.depth_m.values.size(); i += 7) {
    if (!std::isnan(map.depth_m.values[i])) depths.push_back(map.depth_m.values[i]);
  }
  if (depths.empty()) return 0.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::ranges::nth_element(depths, middle);
  return *middle;
}

using VoxelMap = std::unordered_map<std::uint64_t, VoxelSums>;

void add_depths(const DepthMap& map, double voxel_m, double max_depth_m, VoxelMap& voxels) {
  const Eigen::Vector3d centre = map.enu_from_camera.translation;
  for (int y = 0; y < map.grid.height_px; ++y) {
    for (int x = 0; x < map.grid.width_px; ++x) {
      if (!map.has_depth(x, y) || map.depth_m.at(x, y) > max_depth_m) continue;
      const Eigen::Vector3d point = map.point_in_enu(x, y, map.depth_m.at(x, y));
      const double sigma = map.sigma_m.at(x, y);
      const double weight = 1.0 / (sigma * sigma);
      VoxelSums& sums = voxels[voxel_key(voxel_of(point.cast<float>(), voxel_m))];
      sums.weight += weight;
      sums.position += weight * point;
      sums.towards_photo += (centre - point).normalized();
      const Rgb8& rgb = map.rgb.at(x, y);
      sums.color += Eigen::Vector3d(rgb[0], rgb[1], rgb[2]);
      ++sums.count;
    }
  }
}

/// The cloud with `normals` holding the direction to the photos until real normals replace them.
PointCloud cloud_of(const VoxelMap& voxels, int min_count) {
  std::vector<std::pair<std::uint64_t, const VoxelSums*>> kept;
  for (const auto& [key, sums] : voxels) {
    if (sums.count >= min_count) kept.emplace_back(key, &sums);
  }
  std::ranges::sort(kept, {}, &std::pair<std::uint64_t, const VoxelSums*>::first);
  PointCloud cloud;
  for (const auto& [key, sums] : kept) {
    cloud.points.emplace_back((sums->position / sums->weight).cast<float>());
    cloud.normals.emplace_back(sums->towards_photo.stableNormalized().cast<float>());
    const Eigen::Vector3d color = sums->color / sums->count;
    Rgb8 rgb{};
    for (int c = 0; c < 3; ++c) {
      rgb[static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(std::lround(color[c]));
    }
    cloud.colors.push_back(rgb);
    // Depths of one photo share its matching error: count their weights once per photo at most.
    cloud.sigmas_m.push_back(static_cast<float>(std::sqrt(sums->count / sums->weight)));
    cloud.confidences.push_back(static_cast<float>(sums->count));
  }
  return cloud;
}

/// Points whose mean distance to their neighbours is far above the average are specks in the air.
PointCloud without_outliers(const PointCloud& cloud, const RunContext& ctx) {
  constexpr std::size_t kNeighbors = 16;
  constexpr double kMaxSigmas = 3.0;
  if (cloud.size() <= kNeighbors) return cloud;
  const KdTree tree(cloud.points);
  std::vector<double> distance(cloud.size());
  parallel_for(ctx, cloud.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(cloud.points[i], kNeighbors + 1, neighbors);
      for (const Neighbor& n : neighbors)
        distance[i] += std::sqrt(n.squared_distance_m2) / kNeighbors;
    }
  });
  struct Moments {
    double sum = 0.0;
    double squares = 0.0;
  };
  Moments moments;
  for (const double d : distance) {
    moments.sum += d;
    moments.squares += d * d;
  }
  const auto count = static_cast<double>(distance.size());
  const double mean = moments.sum / count;
  const double deviation = std::sqrt(std::max(0.0, moments.squares / count - mean * mean));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (distance[i] <= mean + kMaxSigmas * deviation) kept.push_back(i);
  }
  return select(cloud, kept);
}

void estimate_normals(PointCloud& cloud, const RunContext& ctx) {
  constexpr int kNeighbors = 16;
  const KdTree tree(cloud.points);
  const std::vector<PointShape> shapes = estimate_shapes(cloud.points, tree, kNeighbors, ctx);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float sign = shapes[i].normal.dot(cloud.normals[i]) < 0.0F ? -1.0F : 1.0F;
    cloud.normals[i] = sign * shapes[i].normal;
  }
}

}  // namespace

PointCloud fuse_depth_maps(std::span<const DepthMap> maps,
                           double voxel_m,
                           const DensifyOptions& options,
                           const RunContext& ctx) {
  std::vector<double> medians;
  for (const DepthMap& map : maps) {
    if (!map.depth_m.values.empty()) medians.push_back(median_depth(map));
  }
  std::ranges::sort(medians);
  const double max_depth_m =
      medians.empty() ? 0.0 : options.max_gsd_ratio * medians[medians.size() / 2];
  VoxelMap voxels;
  for (const DepthMap& map : maps) {
    if (!map.depth_m.values.empty()) add_depths(map, voxel_m, max_depth_m, voxels);
  }
  PointCloud cloud = without_outliers(cloud_of(voxels, options.min_points_per_voxel), ctx);
  estimate_normals(cloud, ctx);
  return cloud;
}

}  // namespace hybridfusion
