#pragma once

#include "map_search.hpp"

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// Incremental k-d tree (HybridFusion III-B.2; Cai et al., "ikd-Tree", 2021), written from the
/// paper: insertion that thins as it goes, box deletion by lazy marks that are pushed down when
/// next passed, and rebuilding of every subtree that got unbalanced (scapegoat, Galperin and Rivest
/// 1993). A voxel holds one point: the one nearest to its centre of those inserted.
///
/// Ours: points sit in leaves of up to 16, side by side by coordinate; nodes and leaves are pools
/// addressed by index; planes of division lie on the voxel grid, so that a voxel never straddles
/// leaves and thinning looks at one leaf; a batch of points goes down the tree together; rebuilding
/// is synchronous, so that the same calls give the same tree.
class IncrementalKdTree {
 public:
  /// @pre voxel_m > 0
  explicit IncrementalKdTree(double voxel_m);

  /// Points of one call that share a voxel count as their mean, so that a scan brings a voxel one
  /// point, as in FAST-LIO2. Points are ignored beyond +-2^20 voxels and when not finite.
  void insert(std::span<const Eigen::Vector3f> points);
  /// The `count` nearest points strictly nearer than `radius_m`. @pre 0 < count <= kCapacity
  void nearest(const Eigen::Vector3f& query,
               int count,
               float radius_m,
               MapNeighbors& neighbors) const;
  /// Points in the box, in order of the tree.
  [[nodiscard]] std::vector<Eigen::Vector3f> within_box(const MapBox& box) const;
  /// Points strictly nearer than the radius, in order of the tree.
  [[nodiscard]] std::vector<Eigen::Vector3f> within_radius(const Eigen::Vector3f& center,
                                                           float radius_m) const;
  void erase_box(const MapBox& box);
  /// Drops the points outside the closed cube, and gives their memory back.
  void erase_outside(const Eigen::Vector3f& center, float half_side_m);

  [[nodiscard]] std::size_t size() const { return nodes_[kRoot].num_valid; }
  [[nodiscard]] std::size_t num_bytes() const;
  /// All points, in order of the tree.
  [[nodiscard]] std::vector<Eigen::Vector3f> points() const;
  /// Nodes from the root to the deepest leaf.
  [[nodiscard]] int depth() const { return depth_below(kRoot); }

 private:
  static constexpr std::uint32_t kLeafSize = 16;
  static constexpr std::uint32_t kRoot = 0;
  struct Node {
    Eigen::Vector3f min = Eigen::Vector3f::Zero();  // of the valid points
    Eigen::Vector3f max = Eigen::Vector3f::Zero();
    float split = 0.0F;            // [voxels]; smaller coordinates lie below the first child
    std::uint32_t child = 0;       // the first of two nodes side by side, or the leaf
    std::uint32_t num_stored = 0;  // with points that are deleted but still take memory
    std::uint32_t num_valid = 0;
    std::uint32_t num_changes = 0;  // insertions and deletions since it was built
    std::uint8_t axis = 0;
    bool is_leaf = true;
    bool dropped = false;  // all points below are deleted
    bool touched = false;  // changed since its balance was looked at
  };
  struct Leaf {
    std::array<std::array<float, kLeafSize>, 3> coordinates = {};

    [[nodiscard]] Eigen::Vector3f point(std::uint32_t i) const {
      return {coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    }
    void set(std::uint32_t i, const Eigen::Vector3f& point) {
      for (int axis = 0; axis < 3; ++axis) coordinates[axis][i] = point[axis];
    }
  };
  struct Division {
    int axis = 0;
    float split = 0.0F;
    std::size_t num_heavier = 0;
  };
  using Points = std::span<Eigen::Vector3f>;

  // The voxel grid, and where it can be divided; corners and distances in voxels.
  [[nodiscard]] Eigen::Array3f voxel_corner(const Eigen::Vector3f& point) const;
  [[nodiscard]] float off_center(const Eigen::Vector3f& point) const;
  [[nodiscard]] Points one_per_voxel(Points points) const;
  [[nodiscard]] static bool is_balanced(std::size_t num_heavier, std::size_t num_points);
  [[nodiscard]] Division divide_along(int axis,
                                      int low,
                                      int high,
                                      std::span<const Eigen::Vector3f> points) const;
  [[nodiscard]] Division divide(std::span<const Eigen::Vector3f> points) const;
  [[nodiscard]] Points below(const Division& division, Points points) const;

  // Building and balance.
  void build(std::uint32_t at, Points points);
  void rebuild(std::uint32_t at);
  [[nodiscard]] bool leans(const Node& node) const;
  void rebalance(std::uint32_t at);
  void refresh(std::uint32_t at);
  void push_down(std::uint32_t at);
  [[nodiscard]] int depth_below(std::uint32_t at) const;

  // Pools.
  [[nodiscard]] std::uint32_t allocate_pair();
  [[nodiscard]] std::uint32_t allocate_leaf();
  void release_below(std::uint32_t at);

  // One operation each, for a subtree.
  void insert_below(std::uint32_t at, Points points);
  void insert_into_leaf(std::uint32_t at, Points points);
  [[nodiscard]] bool merge_into_leaf(Node& node, const Eigen::Vector3f& point);
  void nearest_below(std::uint32_t at, const Eigen::Vector3f& query, NearestPoints& best) const;
  template <class Region>
  void erase_below(std::uint32_t at, const Region& region);
  template <class Region>
  void collect_below(std::uint32_t at,
                     const Region& region,
                     std::vector<Eigen::Vector3f>& out) const;

  float inverse_voxel_;
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> free_pairs_ = {};
  std::vector<std::uint32_t> free_leaves_ = {};
};

}  // namespace hybridfusion
