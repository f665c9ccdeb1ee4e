#include "local_map.hpp"

#include <hybridfusion/core/error.hpp>

namespace hybridfusion {

LocalMap::LocalMap(const LocalMapOptions& options) : map_(VoxelMap(options.voxel_m)) {
  HF_CHECK(options.structure == "hash" || options.structure == "ikdtree");
  if (options.structure == "ikdtree") map_ = IncrementalKdTree(options.voxel_m);
}

void LocalMap::insert(std::span<const Eigen::Vector3f> points) {
  std::visit([&](auto& map) { map.insert(points); }, map_);
}

void LocalMap::erase_box(const MapBox& box) {
  std::visit([&](auto& map) { map.erase_box(box); }, map_);
}

void LocalMap::erase_outside(const Eigen::Vector3f& center, float half_side_m) {
  std::visit([&](auto& map) { map.erase_outside(center, half_side_m); }, map_);
}

void LocalMap::nearest(const Eigen::Vector3f& query,
                       int count,
                       float radius_m,
                       MapNeighbors& neighbors) const {
  visit([&](const auto& map) { map.nearest(query, count, radius_m, neighbors); });
}

std::size_t LocalMap::size() const {
  return visit([](const auto& map) { return map.size(); });
}

std::size_t LocalMap::num_bytes() const {
  return visit([](const auto& map) { return map.num_bytes(); });
}

std::vector<Eigen::Vector3f> LocalMap::points() const {
  return visit([](const auto& map) { return map.points(); });
}

}  // namespace hybridfusion
