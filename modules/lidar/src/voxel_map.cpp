#include "voxel_map.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr int kMaxIndex = (1 << 20) - 1;
// After this many points the mean stands: the map is an anchor, not a follower of later drift.
constexpr std::uint8_t kMaxCount = 100;

std::size_t hash_of(std::uint64_t key) {
  key ^= key >> 32U;
  key *= 0x9E3779B97F4A7C15ULL;  // Fibonacci hashing
  return static_cast<std::size_t>(key ^ (key >> 29U));
}

VoxelIndex voxel_of_key(std::uint64_t key) {
  constexpr std::uint64_t kMask = (1U << 21U) - 1U;
  constexpr int kOffset = 1 << 20;
  return {static_cast<int>((key >> 42U) & kMask) - kOffset,
          static_cast<int>((key >> 21U) & kMask) - kOffset,
          static_cast<int>(key & kMask) - kOffset};
}

void keep_nearest(const Eigen::Vector3f& point, float distance, int count, MapNeighbors& best) {
  int at = best.count < count ? best.count++ : count - 1;
  for (; at > 0 && best.squared_distances_m2[at - 1] > distance; --at) {
    best.squared_distances_m2[at] = best.squared_distances_m2[at - 1];
    best.points[at] = best.points[at - 1];
  }
  best.squared_distances_m2[at] = distance;
  best.points[at] = point;
}

}  // namespace

VoxelMap::VoxelMap(double voxel_m)
    : voxel_m_(static_cast<float>(voxel_m)), inverse_cell_(static_cast<float>(0.5 / voxel_m)) {
  HF_CHECK(voxel_m > 0.0);
  slots_.assign(1024, kNone);
}

std::uint32_t VoxelMap::find(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash_of(key) & mask;; i = (i + 1) & mask) {
    const std::uint32_t cell = slots_[i];
    if (cell == kNone || cells_[cell].key == key) return cell;
  }
}

std::uint32_t VoxelMap::find_or_add(std::uint64_t key) {
  if (2 * (cells_.size() + 1) > slots_.size()) rehash(2 * slots_.size());
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash_of(key) & mask;
  for (; slots_[i] != kNone; i = (i + 1) & mask) {
    if (cells_[slots_[i]].key == key) return slots_[i];
  }
  slots_[i] = static_cast<std::uint32_t>(cells_.size());
  cells_.push_back({.key = key});
  return slots_[i];
}

void VoxelMap::rehash(std::size_t num_slots) {
  slots_.assign(num_slots, kNone);
  const std::size_t mask = num_slots - 1;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    std::size_t i = hash_of(cells_[cell].key) & mask;
    while (slots_[i] != kNone) i = (i + 1) & mask;
    slots_[i] = cell;
  }
}

void VoxelMap::insert(const Eigen::Vector3f& point) {
  const Eigen::Array3f scaled = point.array() * inverse_cell_;
  if (!(scaled.abs().maxCoeff() < static_cast<float>(kMaxIndex))) return;
  const Eigen::Array3f floor = scaled.floor();
  Cell& cell = cells_[find_or_add(voxel_key(floor.cast<int>()))];
  const auto octant = (scaled - floor >= 0.5F).cast<int>();
  const int slot = octant.x() + 2 * octant.y() + 4 * octant.z();
  std::uint8_t& count = cell.counts[slot];
  if (count == 0) {
    ++num_points_;
    cell.points[slot] = point;
    count = 1;
  } else if (count < kMaxCount) {
    ++count;
    cell.points[slot] += (point - cell.points[slot]) / static_cast<float>(count);
  }
}

void VoxelMap::nearest(const Eigen::Vector3f& query,
                       int count,
                       float radius_m,
                       MapNeighbors& neighbors) const {
  neighbors.count = 0;
  const Eigen::Array3f scaled = query.array() * inverse_cell_;
  if (!(scaled.abs().maxCoeff() < static_cast<float>(kMaxIndex) - 16.0F)) return;
  const Eigen::Vector3i home = scaled.floor().cast<int>();
  const float cell_m = 2.0F * voxel_m_;
  const Eigen::Vector3f in_cell = (scaled - scaled.floor()).matrix() * cell_m;
  const float radius2 = radius_m * radius_m;
  const auto limit = [&] {
    return neighbors.count == count ? neighbors.squared_distances_m2[count - 1] : radius2;
  };
  // Squared gap between the query and the slab of cells at offset d along one axis.
  const auto gap2 = [&](int axis, int d) {
    if (d == 0) return 0.0F;
    const float gap = d > 0 ? static_cast<float>(d) * cell_m - in_cell[axis]
                            : in_cell[axis] - static_cast<float>(d + 1) * cell_m;
    return gap * gap;
  };
  const int rings = static_cast<int>(std::ceil(radius_m * inverse_cell_));
  // Rings of cells outwards: a ring is left out as soon as it cannot beat the farthest kept point.
  for (int ring = 0; ring <= rings; ++ring) {
    if (ring > 1) {
      float nearest_gap2 = std::numeric_limits<float>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        nearest_gap2 = std::min({nearest_gap2, gap2(axis, ring), gap2(axis, -ring)});
      }
      if (nearest_gap2 >= limit()) return;
    }
    for (int dz = -ring; dz <= ring; ++dz) {
      const float z2 = gap2(2, dz);
      if (z2 >= limit()) continue;
      for (int dy = -ring; dy <= ring; ++dy) {
        const float yz2 = z2 + gap2(1, dy);
        if (yz2 >= limit()) continue;
        const bool inside = std::abs(dz) < ring && std::abs(dy) < ring;
        for (int dx = -ring; dx <= ring; dx += inside ? 2 * ring : 1) {
          if (yz2 + gap2(0, dx) >= limit()) continue;
          const std::uint32_t found = find(voxel_key(home + Eigen::Vector3i(dx, dy, dz)));
          if (found == kNone) continue;
          const Cell& cell = cells_[found];
          for (int slot = 0; slot < 8; ++slot) {
            if (cell.counts[slot] == 0) continue;
            const float distance = (cell.points[slot] - query).squaredNorm();
            if (distance < limit()) keep_nearest(cell.points[slot], distance, count, neighbors);
          }
        }
      }
    }
  }
}

void VoxelMap::erase_outside(const Eigen::Vector3f& center, float half_side_m) {
  const float cell_m = 2.0F * voxel_m_;
  std::erase_if(cells_, [&](const Cell& cell) {
    const Eigen::Vector3f middle = (voxel_of_key(cell.key).cast<float>().array() + 0.5F) * cell_m;
    return (middle - center).cwiseAbs().maxCoeff() > half_side_m;
  });
  cells_.shrink_to_fit();
  num_points_ = 0;
  for (const Cell& cell : cells_) {
    num_points_ += static_cast<std::size_t>(
        std::ranges::count_if(cell.counts, [](std::uint8_t count) { return count > 0; }));
  }
  std::size_t num_slots = 1024;
  while (num_slots < 2 * (cells_.size() + 1)) num_slots *= 2;
  rehash(num_slots);
}

std::size_t VoxelMap::num_bytes() const {
  return slots_.capacity() * sizeof(slots_[0]) + cells_.capacity() * sizeof(Cell);
}

std::vector<Eigen::Vector3f> VoxelMap::points() const {
  std::vector<Eigen::Vector3f> out;
  out.reserve(num_points_);
  for (const Cell& cell : cells_) {
    for (int slot = 0; slot < 8; ++slot) {
      if (cell.counts[slot] > 0) out.push_back(cell.points[slot]);
    }
  }
  return out;
}

}  // namespace hybridfusion
