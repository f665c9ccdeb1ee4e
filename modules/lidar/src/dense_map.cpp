#include "dense_map.hpp"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace hybridfusion {
namespace {

// What is lower than this above the ground near it is ground: rays graze it.
constexpr float kGroundHeight_m = 0.3F;
constexpr float kGroundCell_m = 1.0F;

VoxelIndex index_of(std::uint64_t key) {
  constexpr std::uint64_t kMask = (1U << 21U) - 1U;
  constexpr int kOffset = 1 << 20;
  return {static_cast<int>((key >> 42U) & kMask) - kOffset,
          static_cast<int>((key >> 21U) & kMask) - kOffset,
          static_cast<int>(key & kMask) - kOffset};
}

std::uint64_t ground_key(const Eigen::Vector3f& point) {
  return voxel_key(voxel_of({point.x(), point.y(), 0.0F}, kGroundCell_m));
}

}  // namespace

DenseMap::DenseMap(const DenseMapOptions& options) : options_(options), slots_(1U << 16U, kNone) {}

std::size_t DenseMap::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  // Fibonacci hashing: the highest bits of the product depend on all of the key.
  std::size_t at = (key * 0x9E3779B97F4A7C15ULL) >> static_cast<unsigned>(std::countl_zero(mask));
  while (slots_[at] != kNone && voxels_[slots_[at]].key != key) at = (at + 1) & mask;
  return at;
}

void DenseMap::grow() {
  slots_.assign(2 * slots_.size(), kNone);
  for (std::uint32_t i = 0; i < voxels_.size(); ++i) slots_[slot_of(voxels_[i].key)] = i;
}

void DenseMap::add(std::uint32_t scan,
                   const Eigen::Vector3f& point_in_map,
                   float intensity,
                   float time_s) {
  const std::uint64_t key = voxel_key(voxel_of(point_in_map, options_.voxel_m));
  std::size_t slot = slot_of(key);
  if (slots_[slot] == kNone) {
    if (4 * (voxels_.size() + 1) > 3 * slots_.size()) {
      grow();
      slot = slot_of(key);
    }
    slots_[slot] = static_cast<std::uint32_t>(voxels_.size());
    voxels_.push_back({.key = key, .time_s = time_s});
  }
  Voxel& voxel = voxels_[slots_[slot]];
  voxel.last_time_s = time_s;
  if (voxel.num_points < std::numeric_limits<std::uint16_t>::max()) ++voxel.num_points;
  const float share = 1.0F / static_cast<float>(voxel.num_points);
  voxel.mean += share * (point_in_map - voxel.mean);
  voxel.intensity += share * (intensity - voxel.intensity);
  if (voxel.num_scans == 0 || voxel.last_scan != scan) {
    voxel.last_scan = scan;
    if (voxel.num_scans < std::numeric_limits<std::uint16_t>::max()) ++voxel.num_scans;
  }
}

int DenseMap::scans_near(const Voxel& voxel, int reach) const {
  const VoxelIndex home = index_of(voxel.key);
  const int side = 2 * reach + 1;
  int num_scans = voxel.num_scans;
  for (int i = 0; i < side * side * side && num_scans < options_.min_scans; ++i) {
    const VoxelIndex at =
        home + VoxelIndex(i % side - reach, i / side % side - reach, i / (side * side) - reach);
    const std::uint32_t found = slots_[slot_of(voxel_key(at))];
    // A neighbour hit in the same scan only adds no other scan.
    if (found == kNone || at == home ||
        (voxels_[found].num_scans == 1 && voxel.num_scans == 1 &&
         voxels_[found].last_scan == voxel.last_scan)) {
      continue;
    }
    num_scans += voxels_[found].num_scans;
  }
  return num_scans;
}

bool DenseMap::is_supported(const Voxel& voxel) const {
  // Most voxels need no neighbour, most others the nearest; far surfaces are sampled more thinly.
  for (const int reach : {0, 1, kSupportReach}) {
    if (scans_near(voxel, reach) >= options_.min_scans) return true;
  }
  return false;
}

std::vector<std::uint32_t> DenseMap::brief_voxels() const {
  std::unordered_map<std::uint64_t, float> lowest;
  for (const Voxel& voxel : voxels_) {
    const auto [at, added] = lowest.try_emplace(ground_key(voxel.mean), voxel.mean.z());
    at->second = std::min(at->second, voxel.mean.z());
  }
  std::vector<std::uint32_t> brief;
  for (std::uint32_t i = 0; i < voxels_.size(); ++i) {
    const Voxel& voxel = voxels_[i];
    if (voxel.last_time_s - voxel.time_s <= static_cast<float>(options_.max_brief_s) &&
        voxel.mean.z() > lowest.at(ground_key(voxel.mean)) + kGroundHeight_m &&
        is_supported(voxel)) {
      brief.push_back(i);
    }
  }
  return brief;
}

PointCloud DenseMap::extract(Timestamp time_origin, const PlanBox& box) const {
  PointCloud cloud;
  const double origin_s = to_seconds(time_origin);
  for (const Voxel& voxel : voxels_) {
    const Eigen::Vector2i at = index_of(voxel.key).head<2>();
    if (voxel.dropped || (at.array() < box.low.array()).any() ||
        (at.array() >= box.high.array()).any() || !is_supported(voxel)) {
      continue;
    }
    cloud.points.push_back(voxel.mean);
    cloud.intensities.push_back(voxel.intensity);
    cloud.times_s.push_back(origin_s + voxel.time_s);
  }
  return cloud;
}

}  // namespace hybridfusion
