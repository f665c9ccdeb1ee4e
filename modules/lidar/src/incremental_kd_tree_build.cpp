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

// A division looks at this many counts of points at a time.
constexpr int kNumBins = 64;

bool is_balanced(std::size_t num_heavier, std::size_t num_points) {
  return static_cast<double>(num_heavier) <= kMaxHeavierShare * static_cast<double>(num_points);
}

float floor_of(float value) {
  // std::floor is a call on processors without SSE 4.1.
  const auto truncated = static_cast<float>(static_cast<int>(value));
  return truncated - static_cast<float>(truncated > value);
}

}  // namespace

Eigen::Array3f IncrementalKdTree::voxel_corner(const Eigen::Vector3f& point) const {
  return (point * inverse_voxel_).array().unaryExpr(&floor_of);
}

float IncrementalKdTree::off_center(const Eigen::Vector3f& point) const {
  return ((point * inverse_voxel_).array() - voxel_corner(point) - 0.5F).matrix().squaredNorm();
}

IncrementalKdTree::Points IncrementalKdTree::one_per_voxel(Points points) const {
  if (points.size() < 2) return points;
  struct Entry {
    std::uint64_t voxel;
    Eigen::Vector3f point;
  };
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    entries.push_back({.voxel = voxel_key(voxel_corner(point).cast<int>()), .point = point});
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.voxel, a.point[0], a.point[1], a.point[2]) <
           std::tie(b.voxel, b.point[0], b.point[1], b.point[2]);
  });
  std::size_t num_voxels = 0;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (; end < entries.size() && entries[end].voxel == entries[begin].voxel; ++end) {
      sum += entries[end].point;
    }
    Eigen::Vector3f mean = sum / static_cast<float>(end - begin);
    const Eigen::Vector3f& first = entries[begin].point;
    // Rounding may carry the mean of points on the border of a voxel across it.
    if ((voxel_corner(mean) != voxel_corner(first)).any()) mean = first;
    points[num_voxels++] = mean;
  }
  return points.first(num_voxels);
}

IncrementalKdTree::Points IncrementalKdTree::below(const Division& division, Points points) const {
  const auto above = std::partition(points.begin(), points.end(), [&](const Eigen::Vector3f& p) {
    return p[division.axis] * inverse_voxel_ < division.split;
  });
  return points.first(static_cast<std::size_t>(above - points.begin()));
}

IncrementalKdTree::Division IncrementalKdTree::divide_along(
    int axis, int low, int high, std::span<const Eigen::Vector3f> points) const {
  Division best{.axis = axis, .num_heavier = points.size()};
  std::size_t num_below = 0;  // the range [low, high)
  while (true) {
    int shift = 0;
    while ((high - low - 1) >> shift >= kNumBins) ++shift;
    std::array<std::uint32_t, kNumBins> counts{};
    for (const Eigen::Vector3f& point : points) {
      const int offset = static_cast<int>(floor_of(point[axis] * inverse_voxel_)) - low;
      if (offset >= 0 && offset < high - low) ++counts[static_cast<std::size_t>(offset >> shift)];
    }
    int median_bin = 0;
    std::size_t num_below_median = num_below;
    for (int bin = 0; bin <= (high - low - 1) >> shift; ++bin) {
      if (2 * num_below <= points.size()) {
        median_bin = bin;
        num_below_median = num_below;
      }
      num_below += counts[static_cast<std::size_t>(bin)];
      const std::size_t num_heavier = std::max(num_below, points.size() - num_below);
      if (num_heavier >= best.num_heavier) continue;
      best.split = static_cast<float>(low + ((bin + 1) << shift));
      best.num_heavier = num_heavier;
    }
    if (shift == 0 || is_balanced(best.num_heavier, points.size())) return best;
    low += median_bin << shift;
    high = std::min(high, low + (1 << shift));
    num_below = num_below_median;
  }
}

IncrementalKdTree::Division IncrementalKdTree::divide(
    std::span<const Eigen::Vector3f> points) const {
  Eigen::Vector3f min = points.front();
  Eigen::Vector3f max = points.front();
  for (const Eigen::Vector3f& point : points) {
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
  }
  const Eigen::Vector3f extent = max - min;
  const Eigen::Array3i low = voxel_corner(min).cast<int>();
  const Eigen::Array3i high = voxel_corner(max).cast<int>() + 1;
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::sort(axes, [&](int a, int b) {
    return extent[a] > extent[b] || (extent[a] == extent[b] && a < b);
  });
  Division best{.num_heavier = points.size()};
  for (const int axis : axes) {
    const Division division = divide_along(axis, low[axis], high[axis], points);
    if (division.num_heavier < best.num_heavier) best = division;
    if (is_balanced(best.num_heavier, points.size())) break;
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
