#include "incremental_kd_tree.hpp"

#include <hybridfusion/core/error.hpp>

#include <algorithm>
#include <limits>

namespace hybridfusion {
namespace {

// Criteria of the ikd-Tree for rebuilding a subtree; the balance is in is_balanced().
constexpr double kMaxDeletedShare = 0.5;
// Some sets of voxels (three lines that cross) have no balanced division on the grid; at worst one
// side gets 5/6. Such a subtree is built again only after this share of it has changed.
constexpr double kMinChangedShare = 0.125;

}  // namespace

void IncrementalKdTree::build(std::uint32_t at, Points points) {
  nodes_[at] = Node{};
  if (points.size() <= kLeafSize) {
    const std::uint32_t leaf = allocate_leaf();
    nodes_[at].child = leaf;
    nodes_[at].num_valid = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) leaves_[leaf].set(i, points[i]);
    refresh(at);
    return;
  }
  const Division division = divide(points);
  HF_CHECK(division.num_heavier < points.size());  // no two points share a voxel
  const std::uint32_t pair = allocate_pair();
  nodes_[at].is_leaf = false;
  nodes_[at].child = pair;
  nodes_[at].axis = static_cast<std::uint8_t>(division.axis);
  nodes_[at].split = division.split;
  const Points first = below(division, points);
  build(pair, first);
  build(pair + 1, points.subspan(first.size()));
  refresh(at);
  nodes_[at].num_changes = 0;
  nodes_[at].touched = false;
}

void IncrementalKdTree::refresh(std::uint32_t at) {
  Node& node = nodes_[at];
  node.min.setConstant(std::numeric_limits<float>::infinity());
  node.max = -node.min;
  if (node.is_leaf) {
    const Leaf& leaf = leaves_[node.child];
    node.num_stored = node.num_valid;
    for (std::uint32_t i = 0; i < node.num_valid; ++i) {
      const Eigen::Vector3f point = leaf.point(i);
      node.min = node.min.cwiseMin(point);
      node.max = node.max.cwiseMax(point);
    }
    return;
  }
  const std::uint32_t num_before = node.num_valid;
  node.num_stored = 0;
  node.num_valid = 0;
  for (const std::uint32_t child : {node.child, node.child + 1}) {
    const Node& part = nodes_[child];
    node.num_stored += part.num_stored;
    node.num_valid += part.num_valid;
    if (part.num_valid == 0) continue;
    node.min = node.min.cwiseMin(part.min);
    node.max = node.max.cwiseMax(part.max);
  }
  const std::uint32_t num_changed =
      std::max(node.num_valid, num_before) - std::min(node.num_valid, num_before);
  node.num_changes += num_changed;
  node.touched = node.touched || num_changed > 0;
}

bool IncrementalKdTree::leans(const Node& node) const {
  const double num_stored = node.num_stored;
  if (num_stored - node.num_valid > kMaxDeletedShare * num_stored) return true;
  const std::uint32_t num_heavier =
      std::max(nodes_[node.child].num_stored, nodes_[node.child + 1].num_stored);
  return !is_balanced(num_heavier, node.num_stored) &&
         node.num_changes > kMinChangedShare * num_stored;
}

void IncrementalKdTree::rebalance(std::uint32_t at) {
  if (nodes_[at].is_leaf || !nodes_[at].touched) return;
  nodes_[at].touched = false;
  if (leans(nodes_[at])) {
    rebuild(at);
    return;
  }
  const std::uint32_t child = nodes_[at].child;
  rebalance(child);
  rebalance(child + 1);
  refresh(at);
}

void IncrementalKdTree::push_down(std::uint32_t at) {
  Node& node = nodes_[at];
  node.dropped = false;
  for (const std::uint32_t child : {node.child, node.child + 1}) {
    Node& part = nodes_[child];
    part.num_changes += part.num_valid;
    part.num_valid = 0;
    if (part.is_leaf) {
      part.num_stored = 0;
    } else {
      part.dropped = true;
    }
  }
}

int IncrementalKdTree::depth_below(std::uint32_t at) const {
  const Node& node = nodes_[at];
  return node.is_leaf ? 1 : 1 + std::max(depth_below(node.child), depth_below(node.child + 1));
}

std::uint32_t IncrementalKdTree::allocate_pair() {
  if (!free_pairs_.empty()) {
    const std::uint32_t pair = free_pairs_.back();
    free_pairs_.pop_back();
    return pair;
  }
  const auto pair = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  return pair;
}

std::uint32_t IncrementalKdTree::allocate_leaf() {
  if (!free_leaves_.empty()) {
    const std::uint32_t leaf = free_leaves_.back();
    free_leaves_.pop_back();
    return leaf;
  }
  leaves_.emplace_back();
  return static_cast<std::uint32_t>(leaves_.size() - 1);
}

void IncrementalKdTree::release_below(std::uint32_t at) {
  if (at == kRoot) {  // starts anew, side by side
    nodes_.resize(1);
    leaves_.clear();
    free_pairs_.clear();
    free_leaves_.clear();
    return;
  }
  const Node node = nodes_[at];
  if (node.is_leaf) {
    free_leaves_.push_back(node.child);
    return;
  }
  release_below(node.child);
  release_below(node.child + 1);
  free_pairs_.push_back(node.child);
}

}  // namespace hybridfusion
