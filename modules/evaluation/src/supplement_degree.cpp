#include <hybridfusion/evaluation/supplement_degree.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

void append_cells(std::span<const Eigen::Vector3f> points,
                  double leaf_m,
                  std::vector<std::uint64_t>& cells) {
  for (const Eigen::Vector3f& point : points) {
    if (point.allFinite()) cells.push_back(voxel_key(voxel_of(point, leaf_m)));
  }
}

void keep_distinct(std::vector<std::uint64_t>& cells) {
  std::ranges::sort(cells);
  const auto duplicates = std::ranges::unique(cells);
  cells.erase(duplicates.begin(), duplicates.end());
}

double volume_of(const std::vector<std::uint64_t>& cells, double leaf_m) {
  return static_cast<double>(cells.size()) * std::pow(leaf_m, 3);
}

std::vector<Eigen::Vector3f> inside(std::span<const Eigen::Vector3f> points,
                                    const Eigen::Vector2d& low,
                                    const Eigen::Vector2d& high) {
  std::vector<Eigen::Vector3f> kept;
  std::ranges::copy_if(points, std::back_inserter(kept), [&](const Eigen::Vector3f& point) {
    const Eigen::Array2d xy = point.head<2>().cast<double>().array();
    return (xy >= low.array()).all() && (xy <= high.array()).all();  // false for NaN
  });
  return kept;
}

}  // namespace

double occupied_volume_m3(std::span<const Eigen::Vector3f> points, double leaf_m) {
  HF_CHECK(leaf_m > 0.0);
  std::vector<std::uint64_t> cells;
  append_cells(points, leaf_m, cells);
  keep_distinct(cells);
  return volume_of(cells, leaf_m);
}

double supplement_degree(double fused_volume_m3, double vision_volume_m3) {
  HF_CHECK(vision_volume_m3 > 0.0);
  return (fused_volume_m3 - vision_volume_m3) / vision_volume_m3;
}

Expected<VolumeComparison> compare_volumes(const PointCloud& vision,
                                           const PointCloud& lidar_in_vision,
                                           double leaf_m) {
  HF_CHECK(leaf_m > 0.0);
  VolumeComparison result{.leaf_m = leaf_m};
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3f& point : lidar_in_vision.points) {
    if (point.allFinite()) box.extend(point.head<2>().cast<double>());
  }
  if (box.isEmpty()) {
    return fail(ErrorCode::kInsufficient, "the LiDAR cloud has no finite point to compare");
  }
  result.extent_min = box.min().array() - leaf_m;
  result.extent_max = box.max().array() + leaf_m;
  std::vector<std::uint64_t> cells;
  append_cells(inside(vision.points, result.extent_min, result.extent_max), leaf_m, cells);
  if (cells.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("none of the {} vision points lies in the rectangle of the LiDAR cloud",
                            vision.size()));
  }
  keep_distinct(cells);
  result.vision_volume_m3 = volume_of(cells, leaf_m);
  append_cells(lidar_in_vision.points, leaf_m, cells);
  keep_distinct(cells);
  result.fused_volume_m3 = volume_of(cells, leaf_m);
  result.supplement_degree = supplement_degree(result.fused_volume_m3, result.vision_volume_m3);
  return result;
}

}  // namespace hybridfusion
