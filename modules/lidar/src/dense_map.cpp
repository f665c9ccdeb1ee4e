#include "dense_map.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/geometry/voxel_grid.hpp>

#include <algorithm>

namespace hybridfusion {

DenseMap::DenseMap(const DenseMapOptions& options) : options_(options), slots_(1U << 16U, kNone) {}

std::size_t DenseMap::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 24U) & mask;
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
  if (voxel.num_points < std::numeric_limits<std::uint16_t>::max()) ++voxel.num_points;
  const float share = 1.0F / static_cast<float>(voxel.num_points);
  voxel.mean += share * (point_in_map - voxel.mean);
  voxel.intensity += share * (intensity - voxel.intensity);
  if (voxel.num_scans == 0 || voxel.last_scan != scan) {
    voxel.last_scan = scan;
    if (voxel.num_scans < std::numeric_limits<std::uint16_t>::max()) ++voxel.num_scans;
  }
}

bool DenseMap::is_supported(const Voxel& voxel) const {
  int num_scans = voxel.num_scans;
  const VoxelIndex home = voxel_of(voxel.mean, options_.voxel_m);
  for (int i = 0; i < 27 && num_scans < options_.min_scans; ++i) {
    if (i == 13) continue;
    const VoxelIndex at = home + VoxelIndex(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const std::uint32_t found = slots_[slot_of(voxel_key(at))];
    // A neighbour hit in the same scan only adds no other scan.
    if (found == kNone || (voxels_[found].num_scans == 1 && voxel.num_scans == 1 &&
                           voxels_[found].last_scan == voxel.last_scan)) {
      continue;
    }
    num_scans += voxels_[found].num_scans;
  }
  return num_scans >= options_.min_scans;
}

PointCloud DenseMap::extract(Timestamp time_origin) const {
  PointCloud cloud;
  std::vector<bool> keep(voxels_.size());
  for (std::size_t i = 0; i < voxels_.size(); ++i) keep[i] = is_supported(voxels_[i]);
  const auto count = static_cast<std::size_t>(std::ranges::count(keep, true));
  cloud.points.reserve(count);
  cloud.intensities.reserve(count);
  cloud.times_s.reserve(count);
  const double origin_s = to_seconds(time_origin);
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    if (!keep[i]) continue;
    cloud.points.push_back(voxels_[i].mean);
    cloud.intensities.push_back(voxels_[i].intensity);
    cloud.times_s.push_back(origin_s + voxels_[i].time_s);
  }
  return cloud;
}

Expected<PointCloud> build_dense_map(const DenseMapOptions& options,
                                     const RunContext& ctx,
                                     ScanStore& store) {
  DenseMap map(options);
  const std::vector<StoredScan>& scans = store.scans();
  std::vector<PackedPoint> points;
  if (scans.empty()) return PointCloud{};
  const auto max_range2 = static_cast<float>(options.max_range_m * options.max_range_m);
  const Timestamp origin = scans.front().begin;
  for (std::size_t s = 0; s < scans.size(); ++s) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report({.stage = "lidar/dense_map",
                .done = static_cast<std::int64_t>(s),
                .total = static_cast<std::int64_t>(scans.size())});
    const StoredScan& scan = scans[s];
    const Eigen::Matrix3f rotation = scan.map_from_imu.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f position = scan.map_from_imu.translation.cast<float>();
    const auto begin_s = static_cast<float>(to_seconds(scan.begin - origin));
    const auto span_s = static_cast<float>(to_seconds(scan.time - scan.begin));
    const auto usable = (scan.flags & (static_cast<std::uint32_t>(ScanFlag::kUnmatched) |
                                       static_cast<std::uint32_t>(ScanFlag::kDiverged))) == 0;
    if (auto read = store.read(scan, points); !read) return std::unexpected(read.error());
    for (const PackedPoint& packed : points) {
      if (!usable) break;
      const UnpackedPoint point = unpack(packed);
      if (point.point_in_imu.squaredNorm() > max_range2) continue;
      map.add(static_cast<std::uint32_t>(s),
              rotation * point.point_in_imu + position,
              point.intensity,
              begin_s + point.share * span_s);
    }
    store.drop_points(scan);
  }
  return map.extract(origin);
}

}  // namespace hybridfusion
