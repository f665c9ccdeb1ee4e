#include "incremental_kd_tree.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hybridfusion {
namespace {

// Criteria of the ikd-Tree for rebuilding a subtree.
constexpr double kMaxHeavierShare = 0.6;
constexpr double kMaxDeletedShare = 0.5;
// Some sets of voxels (three lines that cross) have no balanced division on the grid; at worst one
// side gets 5/6. Such a subtree is built again only after this share of it has changed.
constexpr double kMinChangedShare = 0.125;

float floor_of(float value) {
  // std::floor is a call on processors without SSE 4.1.
  const auto truncated = static_cast<float>(static_cast<int>(value));
  return truncated > value ? truncated - 1.0F : truncated;
}

}  // namespace

Eigen::Array3f IncrementalKdTree::voxel_corner(const Eigen::Vector3f& point) const {
  return (point * inverse_voxel_).array().unaryExpr(&floor_of);
}

float IncrementalKdTree::off_center(const Eigen::Vector3f& point) const {
  return ((point * inverse_voxel_).array() - voxel_corner(point) - 0.5F).matrix().squaredNorm();
}

void IncrementalKdTree::thin(std::vector<Eigen::Vector3f>& points) const {
  struct Candidate {
    std::uint64_t voxel;
    float off_center;
    std::uint32_t index;
  };
  std::vector<Candidate> candidates(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    candidates[i] = {.voxel = voxel_key(voxel_corner(points[i]).cast<int>()),
                     .off_center = off_center(points[i]),
                     .index = i};
  }
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    return std::tie(a.voxel, a.off_center, a.index) < std::tie(b.voxel, b.off_center, b.index);
  });
  const auto repeated = std::ranges::unique(candidates, {}, &Candidate::voxel);
  candidates.erase(repeated.begin(), repeated.end());
  std::vector<Eigen::Vector3f> kept;
  kept.reserve(candidates.size());
  for (const Candidate& candidate : candidates) kept.push_back(points[candidate.index]);
  points.swap(kept);
}

IncrementalKdTree::Points IncrementalKdTree::below(const Division& division, Points points) const {
  const auto above = std::partition(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
    return p[division.axis] * inverse_voxel_ < division.split;
  });
  return points.first(static_cast<std::size_t>(above - points.begin()));
}

IncrementalKdTree::Division IncrementalKdTree::divide_along(int axis, Points points) const {
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  std::nth_element(
      points.begin(),
      middle,
      points.end(),
      [axis](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a[axis] < b[axis]; });
  const float median = floor_of((*middle)[axis] * inverse_voxel_);
  Division best{.axis = axis, .num_heavier = points.size()};
  for (const float split : {median, median + 1.0F}) {
    const auto num_below = static_cast<std::size_t>(std::ranges::count_if(
        points, [&](const Eigen::Vector3f& p) { return p[axis] * inverse_voxel_ < split; }));
    const std::size_t num_heavier = std::max(num_below, points.size() - num_below);
    if (num_heavier < best.num_heavier) {
      best = {.axis = axis, .split = split, .num_heavier = num_heavier};
    }
  }
  return best;
}

IncrementalKdTree::Division IncrementalKdTree::divide(Points points) const {
  Eigen::Vector3f min = points.front();
  Eigen::Vector3f max = points.front();
  for (const Eigen::Vector3f& point : points) {
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
  }
  const Eigen::Vector3f extent = max - min;
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, std::ranges::greater{}, [&](int axis) { return extent[axis]; });
  Division best{.num_heavier = points.size()};
  for (const int axis : axes) {
    const Division division = divide_along(axis, points);
    if (division.num_heavier < best.num_heavier) best = division;
    if (static_cast<double>(best.num_heavier) <=
        kMaxHeavierShare * static_cast<double>(points.size())) {
      break;
    }
  }
  return best;
}

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
  node.num_changes += std::max(node.num_valid, num_before) - std::min(node.num_valid, num_before);
}

void IncrementalKdTree::rebalance(std::uint32_t at) {
  const Node& node = nodes_[at];
  if (node.is_leaf) return;
  const double num_stored = node.num_stored;
  if (num_stored - node.num_valid > kMaxDeletedShare * num_stored) {
    rebuild(at);
    return;
  }
  const std::uint32_t num_heavier =
      std::max(nodes_[node.child].num_stored, nodes_[node.child + 1].num_stored);
  if (num_heavier > kMaxHeavierShare * num_stored &&
      node.num_changes > kMinChangedShare * num_stored) {
    rebuild(at);
  }
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
