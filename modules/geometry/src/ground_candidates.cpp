#include "ground_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace hybridfusion {
namespace {

std::uint64_t cell_key(double x, double y, double cell_m) {
  // 32 bits an axis cover +-2e9 cells; far outliers saturate instead of overflowing.
  const auto index = [&](double value) {
    const double cell = std::clamp(std::floor(value / cell_m), -2.0e9, 2.0e9);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell) + (std::int64_t{1} << 31));
  };
  return (index(x) << 32U) | index(y);
}

}  // namespace

std::vector<GroundCandidate> ground_candidates(std::span<const Eigen::Vector3f> points,
                                               const GroundOptions& options) {
  struct Slot {
    std::uint64_t key;
    std::size_t count;
  };
  std::unordered_map<std::uint64_t, std::uint32_t> slot_of;
  std::vector<Slot> slots;
  std::vector<std::uint32_t> slot_of_point(points.size(),
                                           std::numeric_limits<std::uint32_t>::max());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    const std::uint64_t key = cell_key(points[i].x(), points[i].y(), options.cell_m);
    const auto [entry, is_new] = slot_of.try_emplace(key, static_cast<std::uint32_t>(slots.size()));
    if (is_new) slots.push_back({key, 0});
    ++slots[entry->second].count;
    slot_of_point[i] = entry->second;
  }
  std::vector<std::vector<float>> heights(slots.size());
  for (std::size_t s = 0; s < slots.size(); ++s) {
    if (slots[s].count >= static_cast<std::size_t>(options.min_points)) {
      heights[s].reserve(slots[s].count);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t s = slot_of_point[i];
    if (s != std::numeric_limits<std::uint32_t>::max() && heights[s].capacity() > 0) {
      heights[s].push_back(points[i].z());
    }
  }
  std::vector<GroundCandidate> candidates;
  for (std::size_t s = 0; s < slots.size(); ++s) {
    std::vector<float>& z = heights[s];
    if (z.empty()) continue;
    const auto rank =
        static_cast<std::ptrdiff_t>(options.percentile * static_cast<double>(z.size() - 1));
    std::nth_element(z.begin(), z.begin() + rank, z.end());
    const auto cell_x = static_cast<std::int64_t>(slots[s].key >> 32U) - (std::int64_t{1} << 31);
    const auto cell_y =
        static_cast<std::int64_t>(slots[s].key & 0xffffffffU) - (std::int64_t{1} << 31);
    candidates.push_back({cell_x,
                          cell_y,
                          {(static_cast<double>(cell_x) + 0.5) * options.cell_m,
                           (static_cast<double>(cell_y) + 0.5) * options.cell_m,
                           static_cast<double>(z[static_cast<std::size_t>(rank)])}});
  }
  std::ranges::sort(candidates, [](const GroundCandidate& a, const GroundCandidate& b) {
    return a.cell_x != b.cell_x ? a.cell_x < b.cell_x : a.cell_y < b.cell_y;
  });
  return candidates;
}

std::vector<Eigen::Vector3d> block_minima(std::span<const GroundCandidate> candidates,
                                          double block_m) {
  std::unordered_map<std::uint64_t, std::size_t> block_of;
  std::vector<Eigen::Vector3d> lowest;
  for (const GroundCandidate& c : candidates) {
    const auto [entry, is_new] =
        block_of.try_emplace(cell_key(c.point.x(), c.point.y(), block_m), lowest.size());
    if (is_new) {
      lowest.push_back(c.point);
    } else if (c.point.z() < lowest[entry->second].z()) {
      lowest[entry->second] = c.point;
    }
  }
  return lowest;
}

}  // namespace hybridfusion
