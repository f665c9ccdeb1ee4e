#pragma once

#include "incremental_kd_tree.hpp"
#include "voxel_map.hpp"

#include <hybridfusion/lidar/local_map_options.hpp>

#include <concepts>
#include <utility>
#include <variant>

namespace hybridfusion {

/// What matching needs of a map. Both maps thin as they go: at most one point in a voxel. A point
/// that is not finite, or too far out for its voxel to have a number, is ignored.
template <class Map>
concept IncrementalMap = std::copyable<Map> && std::constructible_from<Map, double> &&
                         requires(Map& map,
                                  const Map& view,
                                  std::span<const Eigen::Vector3f> points,
                                  const Eigen::Vector3f& point,
                                  float length_m,
                                  const MapBox& box,
                                  MapNeighbors& neighbors) {
                           map.insert(points);
                           map.erase_box(box);
                           map.erase_outside(point, length_m);
                           view.nearest(point, 5, length_m, neighbors);
                           { view.size() } -> std::same_as<std::size_t>;
                           { view.num_bytes() } -> std::same_as<std::size_t>;
                           { view.points() } -> std::same_as<std::vector<Eigen::Vector3f>>;
                         };

/// Map of the structure that the options name.
class LocalMap {
 public:
  explicit LocalMap(const LocalMapOptions& options);

  void insert(std::span<const Eigen::Vector3f> points);
  void erase_box(const MapBox& box);
  void erase_outside(const Eigen::Vector3f& center, float half_side_m);
  void nearest(const Eigen::Vector3f& query,
               int count,
               float radius_m,
               MapNeighbors& neighbors) const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::size_t num_bytes() const;
  [[nodiscard]] std::vector<Eigen::Vector3f> points() const;

  /// Gives the structure itself to `queries`: a loop of many queries asks once which it is.
  template <class Queries>
  decltype(auto) visit(Queries&& queries) const {
    return std::visit(std::forward<Queries>(queries), map_);
  }

 private:
  static_assert(IncrementalMap<VoxelMap> && IncrementalMap<IncrementalKdTree>);
  std::variant<VoxelMap, IncrementalKdTree> map_;
};

}  // namespace hybridfusion
