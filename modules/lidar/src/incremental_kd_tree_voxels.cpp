#include "incremental_kd_tree.hpp"

#include <hybridfusion/core/floor.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <tuple>

namespace hybridfusion {
namespace {

// A division looks at this many counts of points at a time.
constexpr int kNumBins = 64;

}  // namespace

bool IncrementalKdTree::is_balanced(std::size_t num_heavier, std::size_t num_points) {
  constexpr double kMaxHeavierShare = 0.6;  // of the ikd-Tree
  return static_cast<double>(num_heavier) <= kMaxHeavierShare * static_cast<double>(num_points);
}

Eigen::Array3f IncrementalKdTree::voxel_corner(const Eigen::Vector3f& point) const {
  return (point * inverse_voxel_).array().unaryExpr([](float value) { return floor_of(value); });
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

}  // namespace hybridfusion
