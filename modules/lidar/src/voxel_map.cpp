#include "voxel_map.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/floor.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr int kMaxIndex = (1 << 20) - 1;
// After this many points the mean stands: the map is an anchor, not a follower of later drift.
constexpr std::uint8_t kMaxCount = 100;

std::uint64_t hash_of(std::uint64_t key) {
  key ^= key >> 32U;
  key *= 0x9E3779B97F4A7C15ULL;  // Fibonacci hashing
  return key ^ (key >> 29U);
}

std::uint32_t tag_of(std::uint64_t hash) {
  return static_cast<std::uint32_t>(hash >> 32U);
}

/// A cell and the 26 around it as codes an axis: 0 the same, 1 the side that the query is nearer
/// to, 2 the other side. Those that touch the query's octant come first.
constexpr auto kAround = [] {
  std::array<std::array<std::uint8_t, 3>, 27> codes{};
  for (std::uint8_t i = 0; i < 27; ++i) {
    codes[i] = {static_cast<std::uint8_t>(i % 3),
                static_cast<std::uint8_t>(i / 3 % 3),
                static_cast<std::uint8_t>(i / 9)};
  }
  const auto distance = [](const auto& code) {
    // A far side is at least half a cell off, farther than a near corner mostly is.
    constexpr std::array<int, 3> kCosts{0, 1, 4};
    return kCosts[code[0]] + kCosts[code[1]] + kCosts[code[2]];
  };
  std::ranges::sort(codes, [&](const auto& a, const auto& b) {
    return distance(a) < distance(b) || (distance(a) == distance(b) && a < b);
  });
  return codes;
}();

/// NaN when any coordinate is.
float largest_of(const Eigen::Array3f& scaled) {
  return scaled.abs().maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace

VoxelMap::VoxelMap(double voxel_m)
    : voxel_m_(static_cast<float>(voxel_m)), inverse_cell_(static_cast<float>(0.5 / voxel_m)) {
  HF_CHECK(voxel_m > 0.0);
  slots_.assign(1024, Slot{});
}

std::size_t VoxelMap::slot_of(std::uint64_t key) const {
  const std::uint64_t hash = hash_of(key);
  const std::uint32_t tag = tag_of(hash);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
    const Slot& slot = slots_[i];
    if (slot.cell == kNone || (slot.tag == tag && cells_[slot.cell].key == key)) return i;
  }
}

std::uint32_t VoxelMap::find(std::uint64_t key) const {
  return slots_[slot_of(key)].cell;
}

std::uint32_t VoxelMap::find_or_add(std::uint64_t key) {
  if (2 * (cells_.size() + 1) > slots_.size()) rehash(2 * slots_.size());
  Slot& slot = slots_[slot_of(key)];
  if (slot.cell == kNone) {
    slot = {.tag = tag_of(hash_of(key)), .cell = static_cast<std::uint32_t>(cells_.size())};
    cells_.push_back({.key = key});
  }
  return slot.cell;
}

void VoxelMap::rehash(std::size_t num_slots) {
  slots_.assign(num_slots, Slot{});
  const std::size_t mask = num_slots - 1;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    const std::uint64_t hash = hash_of(cells_[cell].key);
    std::size_t i = hash & mask;
    while (slots_[i].cell != kNone) i = (i + 1) & mask;
    slots_[i] = {.tag = tag_of(hash), .cell = cell};
  }
}

void VoxelMap::insert(std::span<const Eigen::Vector3f> points) {
  // Neighbours in time lie far apart in the map. Going through a batch three times lets the memory
  // fetch slots and cells of many points at once.
  constexpr std::size_t kBatch = 32;
  std::array<Target, kBatch> targets;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    std::size_t count = 0;
    for (const Eigen::Vector3f& point :
         points.subspan(first, std::min(kBatch, points.size() - first))) {
      const Eigen::Array3f scaled = point.array() * inverse_cell_;
      if (!(largest_of(scaled) < static_cast<float>(kMaxIndex))) continue;
      const Eigen::Array3f floor = scaled.unaryExpr([](float value) { return floor_of(value); });
      const auto octant = (scaled - floor >= 0.5F).cast<int>();
      targets[count] = {.point = point,
                        .key = voxel_key(floor.cast<int>()),
                        .slot = octant.x() + 2 * octant.y() + 4 * octant.z()};
      __builtin_prefetch(&slots_[hash_of(targets[count].key) & (slots_.size() - 1)]);
      ++count;
    }
    const std::span<Target> batch = std::span(targets).first(count);
    for (Target& target : batch) {
      target.cell = find_or_add(target.key);
      __builtin_prefetch(&cells_[target.cell].points[target.slot]);
      __builtin_prefetch(&cells_[target.cell].counts);
    }
    for (const Target& target : batch) add(target);
  }
}

void VoxelMap::add(const Target& target) {
  Cell& cell = cells_[target.cell];
  std::uint8_t& count = cell.counts[target.slot];
  Eigen::Vector3f& mean = cell.points[target.slot];
  if (count == 0) {
    ++num_points_;
    mean = target.point;
    count = 1;
  } else if (count < kMaxCount) {
    ++count;
    mean += (target.point - mean) / static_cast<float>(count);
  }
}

/// A query among the cells around its own.
struct VoxelMap::Search {
  Eigen::Vector3f query;
  Eigen::Vector3i home;
  Eigen::Vector3f in_cell;  // [m], from the lower corner of the home cell
  float cell_m;
  NearestPoints best;

  /// Squared distance from the query to the slab of cells at offset `d` along one axis.
  [[nodiscard]] float squared_gap(int axis, int d) const {
    if (d == 0) return 0.0F;
    const float gap = d > 0 ? static_cast<float>(d) * cell_m - in_cell[axis]
                            : in_cell[axis] - static_cast<float>(d + 1) * cell_m;
    return gap * gap;
  }
  /// Squared distance to the nearest cell of a ring.
  [[nodiscard]] float squared_ring_gap(int ring) const {
    float gap = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      gap = std::min({gap, squared_gap(axis, ring), squared_gap(axis, -ring)});
    }
    return gap;
  }
};

void VoxelMap::search_cell(const Eigen::Vector3i& offset, Search& search) const {
  const std::uint32_t found = find(voxel_key(search.home + offset));
  if (found == kNone) return;
  const Cell& cell = cells_[found];
  for (int slot = 0; slot < 8; ++slot) {
    if (cell.counts[slot] == 0) continue;
    search.best.offer(cell.points[slot], (cell.points[slot] - search.query).squaredNorm());
  }
}

void VoxelMap::search_nearest_cells(Search& search) const {
  std::array<std::array<int, 3>, 3> offsets{};
  std::array<std::array<float, 3>, 3> gaps{};
  for (int axis = 0; axis < 3; ++axis) {
    const int near = search.squared_gap(axis, -1) < search.squared_gap(axis, 1) ? -1 : 1;
    offsets[axis] = {0, near, -near};
    for (int code = 0; code < 3; ++code) {
      gaps[axis][code] = search.squared_gap(axis, offsets[axis][code]);
    }
  }
  for (const auto& [x, y, z] : kAround) {
    if (gaps[0][x] + gaps[1][y] + gaps[2][z] >= search.best.limit()) continue;
    search_cell({offsets[0][x], offsets[1][y], offsets[2][z]}, search);
  }
}

void VoxelMap::search_ring(int ring, Search& search) const {
  for (int dz = -ring; dz <= ring; ++dz) {
    const float z2 = search.squared_gap(2, dz);
    if (z2 >= search.best.limit()) continue;
    for (int dy = -ring; dy <= ring; ++dy) {
      const float yz2 = z2 + search.squared_gap(1, dy);
      if (yz2 >= search.best.limit()) continue;
      const bool inside = std::abs(dz) < ring && std::abs(dy) < ring;
      for (int dx = -ring; dx <= ring; dx += inside ? 2 * ring : 1) {
        if (yz2 + search.squared_gap(0, dx) >= search.best.limit()) continue;
        search_cell({dx, dy, dz}, search);
      }
    }
  }
}

void VoxelMap::nearest(const Eigen::Vector3f& query,
                       int count,
                       float radius_m,
                       MapNeighbors& neighbors) const {
  HF_CHECK(count > 0 && count <= MapNeighbors::kCapacity);
  NearestPoints best(count, radius_m, neighbors);
  const Eigen::Array3f scaled = query.array() * inverse_cell_;
  if (!(largest_of(scaled) < static_cast<float>(kMaxIndex) - 16.0F)) return;
  const Eigen::Array3f floor = scaled.unaryExpr([](float value) { return floor_of(value); });
  const float cell_m = 2.0F * voxel_m_;
  Search search{.query = query,
                .home = floor.cast<int>(),
                .in_cell = (scaled - floor).matrix() * cell_m,
                .cell_m = cell_m,
                .best = best};
  search_nearest_cells(search);
  // Rings of cells outwards: a ring is left out as soon as it cannot beat the farthest kept point.
  const int num_rings = static_cast<int>(std::ceil(radius_m * inverse_cell_));
  for (int ring = 2; ring <= num_rings; ++ring) {
    if (search.squared_ring_gap(ring) >= search.best.limit()) return;
    search_ring(ring, search);
  }
}

template <class Predicate>
void VoxelMap::erase_points(const Predicate& goes) {
  num_points_ = 0;
  std::erase_if(cells_, [&](Cell& cell) {
    std::size_t num_kept = 0;
    for (int slot = 0; slot < 8; ++slot) {
      if (cell.counts[slot] > 0 && goes(cell.points[slot])) cell.counts[slot] = 0;
      if (cell.counts[slot] > 0) ++num_kept;
    }
    num_points_ += num_kept;
    return num_kept == 0;
  });
  std::size_t num_slots = 1024;
  while (num_slots < 2 * (cells_.size() + 1)) num_slots *= 2;
  rehash(num_slots);
}

void VoxelMap::erase_box(const MapBox& box) {
  erase_points([&](const Eigen::Vector3f& point) { return box.contains(point); });
}

void VoxelMap::erase_outside(const Eigen::Vector3f& center, float half_side_m) {
  erase_points([&](const Eigen::Vector3f& point) {
    return (point - center).cwiseAbs().maxCoeff() > half_side_m;
  });
  cells_.shrink_to_fit();
  slots_.shrink_to_fit();
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
