#include "incremental_kd_tree.hpp"

#include "map_regions.hpp"

#include <hybridfusion/core/error.hpp>

#include <algorithm>

namespace hybridfusion {
namespace {

constexpr float kMaxIndex = static_cast<float>((1 << 20) - 1);

}  // namespace

IncrementalKdTree::IncrementalKdTree(double voxel_m)
    : inverse_voxel_(static_cast<float>(1.0 / voxel_m)), nodes_(1), leaves_(1) {
  HF_CHECK(voxel_m > 0.0);
}

void IncrementalKdTree::insert(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3f> batch;
  batch.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    if ((point * inverse_voxel_).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < kMaxIndex) {
      batch.push_back(point);
    }
  }
  insert_below(kRoot, batch);
  rebalance(kRoot);
}

void IncrementalKdTree::insert_below(std::uint32_t at, Points points) {
  if (points.empty()) return;
  if (nodes_[at].is_leaf) {
    insert_into_leaf(at, points);
    return;
  }
  if (nodes_[at].dropped) push_down(at);
  const Points first = below({.axis = nodes_[at].axis, .split = nodes_[at].split}, points);
  insert_below(nodes_[at].child, first);
  insert_below(nodes_[at].child + 1, points.subspan(first.size()));
  refresh(at);
}

void IncrementalKdTree::insert_into_leaf(std::uint32_t at, Points points) {
  std::vector<Eigen::Vector3f> overflow;
  for (const Eigen::Vector3f& point : one_per_voxel(points)) {
    if (!merge_into_leaf(nodes_[at], point)) overflow.push_back(point);
  }
  refresh(at);
  if (overflow.empty()) return;
  const std::uint32_t leaf = nodes_[at].child;
  for (std::uint32_t i = 0; i < nodes_[at].num_valid; ++i) {
    overflow.push_back(leaves_[leaf].point(i));
  }
  free_leaves_.push_back(leaf);
  build(at, overflow);
}

bool IncrementalKdTree::merge_into_leaf(Node& node, const Eigen::Vector3f& point) {
  Leaf& leaf = leaves_[node.child];
  const Eigen::Array3f low = voxel_corner(point);
  std::array<int, kLeafSize> same;
  same.fill(1);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t i = 0; i < kLeafSize; ++i) {
      const float scaled = leaf.coordinates[axis][i] * inverse_voxel_;
      same[i] &=
          static_cast<int>(scaled >= low[axis]) & static_cast<int>(scaled < low[axis] + 1.0F);
    }
  }
  for (std::uint32_t i = 0; i < node.num_valid; ++i) {
    if (same[i] == 0) continue;
    if (off_center(point) < off_center(leaf.point(i))) leaf.set(i, point);
    return true;
  }
  if (node.num_valid == kLeafSize) return false;
  leaf.set(node.num_valid++, point);
  return true;
}

void IncrementalKdTree::nearest(const Eigen::Vector3f& query,
                                int count,
                                float radius_m,
                                MapNeighbors& neighbors) const {
  HF_CHECK(count > 0 && count <= MapNeighbors::kCapacity);
  NearestPoints best(count, radius_m, neighbors);
  nearest_below(kRoot, query, best);
}

void IncrementalKdTree::nearest_below(std::uint32_t at,
                                      const Eigen::Vector3f& query,
                                      NearestPoints& best) const {
  const Node& node = nodes_[at];
  if (node.num_valid == 0) return;
  if (node.is_leaf) {
    const Leaf& leaf = leaves_[node.child];
    std::array<float, kLeafSize> distances;
    for (std::uint32_t i = 0; i < kLeafSize; ++i) {
      const float dx = leaf.coordinates[0][i] - query.x();
      const float dy = leaf.coordinates[1][i] - query.y();
      const float dz = leaf.coordinates[2][i] - query.z();
      distances[i] = dx * dx + (dy * dy + dz * dz);
    }
    for (std::uint32_t i = 0; i < node.num_valid; ++i) {
      if (distances[i] < best.limit()) best.offer(leaf.point(i), distances[i]);
    }
    return;
  }
  const auto gap_of = [&](std::uint32_t child) {
    return squared_gap(nodes_[child].min, nodes_[child].max, query);
  };
  std::uint32_t near = node.child;
  std::uint32_t far = near + 1;
  float near_gap = gap_of(near);
  float far_gap = gap_of(far);
  if (far_gap < near_gap) {
    std::swap(near, far);
    std::swap(near_gap, far_gap);
  }
  if (near_gap < best.limit()) nearest_below(near, query, best);
  if (far_gap < best.limit()) nearest_below(far, query, best);
}

template <class Region>
void IncrementalKdTree::erase_below(std::uint32_t at, const Region& region) {
  Node& node = nodes_[at];
  if (node.num_valid == 0 || region.misses(node.min, node.max)) return;
  if (node.is_leaf) {
    Leaf& leaf = leaves_[node.child];
    for (std::uint32_t i = node.num_valid; i-- > 0;) {
      if (region.contains(leaf.point(i))) leaf.set(i, leaf.point(--node.num_valid));
    }
    refresh(at);
    return;
  }
  if (region.covers(node.min, node.max)) {
    node.dropped = true;
    node.touched = true;
    node.num_changes += node.num_valid;
    node.num_valid = 0;
    return;
  }
  erase_below(node.child, region);
  erase_below(node.child + 1, region);
  refresh(at);
}

template <class Region>
void IncrementalKdTree::collect_below(std::uint32_t at,
                                      const Region& region,
                                      std::vector<Eigen::Vector3f>& out) const {
  const Node& node = nodes_[at];
  if (node.num_valid == 0 || region.misses(node.min, node.max)) return;
  if (!node.is_leaf) {
    collect_below(node.child, region, out);
    collect_below(node.child + 1, region, out);
    return;
  }
  for (std::uint32_t i = 0; i < node.num_valid; ++i) {
    const Eigen::Vector3f point = leaves_[node.child].point(i);
    if (region.contains(point)) out.push_back(point);
  }
}

void IncrementalKdTree::rebuild(std::uint32_t at) {
  std::vector<Eigen::Vector3f> kept;
  kept.reserve(nodes_[at].num_valid);
  collect_below(at, Everything{}, kept);
  release_below(at);
  build(at, kept);
}

void IncrementalKdTree::erase_box(const MapBox& box) {
  erase_below(kRoot, InBox{box});
  rebalance(kRoot);
}

void IncrementalKdTree::erase_outside(const Eigen::Vector3f& center, float half_side_m) {
  erase_below(kRoot, OutsideCube{center, half_side_m});
  rebuild(kRoot);
  nodes_.shrink_to_fit();
  leaves_.shrink_to_fit();
}

std::vector<Eigen::Vector3f> IncrementalKdTree::within_box(const MapBox& box) const {
  std::vector<Eigen::Vector3f> out;
  collect_below(kRoot, InBox{box}, out);
  return out;
}

std::vector<Eigen::Vector3f> IncrementalKdTree::within_radius(const Eigen::Vector3f& center,
                                                              float radius_m) const {
  std::vector<Eigen::Vector3f> out;
  collect_below(kRoot, InBall{center, radius_m * radius_m}, out);
  return out;
}

std::vector<Eigen::Vector3f> IncrementalKdTree::points() const {
  std::vector<Eigen::Vector3f> out;
  out.reserve(size());
  collect_below(kRoot, Everything{}, out);
  return out;
}

std::size_t IncrementalKdTree::num_bytes() const {
  return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf) +
         (free_pairs_.capacity() + free_leaves_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace hybridfusion
