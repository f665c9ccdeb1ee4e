#include "scan_store.hpp"

#include <hybridfusion/core/error.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hybridfusion {
namespace {

constexpr float kGrid_m = 1e-3F;
constexpr std::int32_t kOffset = 1 << 20;
constexpr std::int32_t kMax = (1 << 21) - 1;
constexpr std::uint64_t kMask = (1U << 21U) - 1U;

std::uint64_t to_grid(float value) {
  const auto rounded = static_cast<std::int32_t>(std::lround(value / kGrid_m));
  return static_cast<std::uint64_t>(std::clamp(rounded + kOffset, 0, kMax));
}

float from_grid(std::uint64_t bits) {
  return static_cast<float>(static_cast<std::int32_t>(bits & kMask) - kOffset) * kGrid_m;
}

}  // namespace

PackedPoint pack(const UnpackedPoint& point) {
  const std::uint64_t xyz = to_grid(point.point_in_imu.x()) |
                            (to_grid(point.point_in_imu.y()) << 21U) |
                            (to_grid(point.point_in_imu.z()) << 42U);
  // The upper half of a float, rounded: integers up to 256 survive exactly.
  const std::uint32_t intensity = std::bit_cast<std::uint32_t>(point.intensity) + 0x8000U;
  return {.xy_low = static_cast<std::uint32_t>(xyz),
          .xy_high_z = static_cast<std::uint32_t>(xyz >> 32U),
          .intensity = static_cast<std::uint16_t>(intensity >> 16U),
          .time = static_cast<std::uint16_t>(
              std::lround(std::clamp(point.share, 0.0F, 1.0F) * 65535.0F))};
}

UnpackedPoint unpack(const PackedPoint& point) {
  const std::uint64_t xyz = (static_cast<std::uint64_t>(point.xy_high_z) << 32U) | point.xy_low;
  return {.point_in_imu = {from_grid(xyz), from_grid(xyz >> 21U), from_grid(xyz >> 42U)},
          .intensity = std::bit_cast<float>(static_cast<std::uint32_t>(point.intensity) << 16U),
          .share = static_cast<float>(point.time) / 65535.0F};
}

ScanStore::ScanStore(int max_points_per_scan, SpillFile spill)
    : max_points_per_scan_(static_cast<std::size_t>(max_points_per_scan)),
      spill_(std::move(spill)) {
  HF_CHECK(max_points_per_scan > 0);
}

Expected<void> ScanStore::add(const ScanEstimate& scan) {
  StoredScan stored{.begin = scan.start,
                    .time = scan.time,
                    .map_from_imu = scan.map_from_imu,
                    .gravity_in_imu = scan.map_from_imu.rotation.conjugate() * scan.gravity_in_map,
                    .gravity_sigma_rad = scan.gravity_sigma_rad,
                    .since_last = scan.since_last,
                    .lidar_in_imu = scan.imu_from_lidar.translation.cast<float>(),
                    .flags = scan.quality.flags};
  std::vector<PackedPoint> packed;
  if (!scan.deskewed.empty()) {
    stored.begin = scan.start + Timestamp(scan.deskewed.front().offset_ns);
    const auto first_ns = static_cast<double>(scan.deskewed.front().offset_ns);
    const double span_ns = std::max(1.0, static_cast<double>((scan.time - stored.begin).count()));
    const std::size_t stride = (scan.deskewed.size() - 1) / max_points_per_scan_ + 1;
    packed.reserve(scan.deskewed.size() / stride + 1);
    for (std::size_t i = 0; i < scan.deskewed.size(); i += stride) {
      const LidarPoint& point = scan.deskewed[i];
      packed.push_back(pack({.point_in_imu = point.point_in_lidar,
                             .intensity = point.intensity,
                             .share = static_cast<float>((point.offset_ns - first_ns) / span_ns)}));
    }
  }
  stored.num_points = packed.size();
  HF_TRY(stored.block, spill_.append(std::as_bytes(std::span(packed))));
  scans_.push_back(stored);
  return {};
}

Expected<void> ScanStore::read(const StoredScan& scan, std::vector<PackedPoint>& out) const {
  std::vector<std::byte> bytes;
  if (auto done = spill_.read(scan.block, bytes); !done) return done;
  out.resize(bytes.size() / sizeof(PackedPoint));
  if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size() * sizeof(PackedPoint));
  return {};
}

}  // namespace hybridfusion
