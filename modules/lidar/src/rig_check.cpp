#include "rig_check.hpp"

#include "manifold.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kSpan = 4;  // scans between the two ends
constexpr int kMinSpans = 12;
constexpr double kSigmas = 5.0;
constexpr double kMinOffset_s = 0.006;
constexpr double kMinAngle_rad = 0.01;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}
constexpr std::uint32_t kUnusable = bit(ScanFlag::kImuGap) | bit(ScanFlag::kLidarGap) |
                                    bit(ScanFlag::kFewPoints) | bit(ScanFlag::kUnmatched) |
                                    bit(ScanFlag::kDegenerate) | bit(ScanFlag::kDiverged) |
                                    bit(ScanFlag::kSaturated) | bit(ScanFlag::kNoPointTimes);

}  // namespace

void RigCheck::add(const ScanEstimate& scan) {
  if ((scan.quality.flags & kUnusable) != 0 || scan.since_last.duration_s <= 0.0) {
    recent_.clear();
    return;
  }
  recent_.push_back({.map_from_imu = scan.map_from_imu.rotation,
                     .turn = scan.since_last.rotation,
                     .duration_s = scan.since_last.duration_s});
  // Pose 0 | turns 1 .. kSpan + 1 | one more turn, for the rate at the end of the span.
  constexpr std::size_t kLast = kSpan + 1;
  if (recent_.size() < kLast + 2) return;
  const auto rate = [&](std::size_t i) -> Eigen::Vector3d {
    return so3_log(recent_[i].turn) / recent_[i].duration_s;
  };
  Eigen::Matrix3d by_gyro = Eigen::Matrix3d::Identity();
  double duration_s = 0.0;
  for (std::size_t i = 2; i <= kLast; ++i) {
    by_gyro = by_gyro * recent_[i].turn;
    duration_s += recent_[i].duration_s;
  }
  const Eigen::Quaterniond by_lidar =
      recent_[1].map_from_imu.conjugate() * recent_[kLast].map_from_imu;
  const Eigen::Vector3d left = so3_log(by_lidar.toRotationMatrix().transpose() * by_gyro);
  const Eigen::Vector3d change = 0.5 * (rate(kLast) + rate(kLast + 1)) - 0.5 * (rate(1) + rate(2));
  Eigen::Matrix<double, 3, kSize> row;
  row << skew(so3_log(by_gyro)), -change, duration_s * Eigen::Matrix3d::Identity();
  normal_ += row.transpose() * row;
  right_ += row.transpose() * left;
  squares_ += left.squaredNorm();
  ++num_spans_;
  // Spans do not overlap.
  recent_.erase(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(kSpan));
}

std::vector<std::string> RigCheck::warnings() const {
  std::vector<std::string> out;
  if (num_spans_ < kMinSpans) return out;
  Eigen::Matrix<double, kSize, kSize> normal = normal_;
  normal.diagonal().array() += 1e-9;
  const Eigen::Matrix<double, kSize, kSize> inverse = normal.inverse();
  const Eigen::Matrix<double, kSize, 1> fit = inverse * right_;
  const double variance = std::max(0.0, squares_ - fit.dot(right_)) / (3.0 * num_spans_ - kSize);
  const double offset_sigma = std::sqrt(variance * inverse(3, 3));
  if (std::abs(fit[3]) > std::max(kMinOffset_s, kSigmas * offset_sigma)) {
    out.push_back(
        fmt::format("LiDAR and IMU seem to have a time offset of {:.0f} ms or more; find it with "
                    "'hybridfusion map --calibrate' or set lidar.odometry.imu_time_offset_s",
                    1e3 * fit[3]));
  }
  const Eigen::Vector3d theta = fit.head<3>();
  const double theta_sigma = std::sqrt(variance * inverse.topLeftCorner<3, 3>().trace());
  const double angle_rad = theta.norm();
  if (angle_rad > std::max(kMinAngle_rad, kSigmas * theta_sigma)) {
    out.push_back(fmt::format(
        "imu_from_lidar seems to be off by {:.1f} degrees or more; find it with 'hybridfusion map "
        "--calibrate' or correct sensors.yaml",
        angle_rad * 180.0 / std::numbers::pi));
  }
  return out;
}

}  // namespace hybridfusion
