#include "drive_judgement.hpp"

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Beyond what people, cars and drones do for the time of a scan, with room for the noise of the
// poses: three poses of 3 cm in 0.1 s leave 7 m/s^2.
constexpr double kMaxAcceleration_mps2 = 40.0;
// So many of them are no glitch of single scans.
constexpr std::size_t kMaxJumps = 3;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}
constexpr std::uint32_t kExplained = bit(ScanFlag::kImuGap) | bit(ScanFlag::kLidarGap) |
                                     bit(ScanFlag::kUnmatched) | bit(ScanFlag::kClockStep);

struct Jumps {
  std::size_t count = 0;
  double largest_mps2 = 0.0;
};

Jumps jumps_of(std::span<const StoredScan> scans) {
  Jumps jumps;
  for (std::size_t i = 2; i < scans.size(); ++i) {
    if (((scans[i - 2].flags | scans[i - 1].flags | scans[i].flags) & kExplained) != 0) continue;
    const double before_s = to_seconds(scans[i - 1].time - scans[i - 2].time);
    const double after_s = to_seconds(scans[i].time - scans[i - 1].time);
    if (!(before_s > 0.0) || !(after_s > 0.0)) continue;
    const auto at = [&](std::size_t k) { return scans[k].map_from_imu.translation; };
    const Eigen::Vector3d change =
        (at(i) - at(i - 1)) / after_s - (at(i - 1) - at(i - 2)) / before_s;
    const double acceleration = change.norm() / (0.5 * (before_s + after_s));
    if (!(acceleration > kMaxAcceleration_mps2)) continue;
    ++jumps.count;
    jumps.largest_mps2 = std::max(jumps.largest_mps2, acceleration);
  }
  return jumps;
}

}  // namespace

std::vector<std::string> contradictions_of(const OdometrySummary& summary,
                                           std::span<const StoredScan> scans) {
  std::vector<std::string> out;
  if (!summary.imu_doubts.empty()) {
    std::string text = "the IMU contradicts the LiDAR";
    for (std::size_t i = 0; i < summary.imu_doubts.size(); ++i) {
      text += (i == 0 ? ": " : "; ") + summary.imu_doubts[i];
    }
    out.push_back(text +
                  ". Check imu_from_lidar, the time stamps and the units of the IMU; or map from "
                  "the LiDAR alone with --set lidar.imu=none");
  }
  const Jumps jumps = jumps_of(scans);
  if (jumps.count >= kMaxJumps) {
    out.push_back(fmt::format(
        "the trajectory jumps: {} scans would need an acceleration of up to {:.0f} m/s^2; are the "
        "scans of one sensor, and are their stamps right?",
        jumps.count,
        jumps.largest_mps2));
  }
  return out;
}

}  // namespace hybridfusion
