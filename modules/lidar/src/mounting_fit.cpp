#include "mounting_fit.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kGravity_mps2 = 9.81;
// Deviations by which turns and forces are weighed: of a scan pose, and of vibration and the
// difference of three poses.
constexpr double kTurnSigma_rad = 3e-3;
constexpr double kForceSigma_mps2 = 1.0;
// Mean turn between scans over its deviation that makes axes visible.
constexpr double kMinTurnOverSigma = 1.5;
// How much less a mirror must leave over than a turn: some hundred pairs tell this from noise.
constexpr double kMirrorGain = 0.95;
constexpr double kMaxErrorAfter = 0.35;

/// The force that the LiDAR's motion would make an IMU in the given axes feel.
Eigen::Vector3d expected_force(const MotionPair& pair, const Eigen::Vector3d& up_in_map) {
  return pair.acceleration_mps2 + kGravity_mps2 * (pair.map_from_imu.transpose() * up_in_map);
}

struct Totals {
  Eigen::Matrix3d profile = Eigen::Matrix3d::Zero();  // sum of w lidar imu^T
  double lidar2 = 0.0;                                // sum of w |lidar|^2
  double imu2 = 0.0;
};

Totals totals(std::span<const MotionPair> pairs, const Eigen::Vector3d& up_in_map, double scale) {
  constexpr double kTurnWeight = 1.0 / (kTurnSigma_rad * kTurnSigma_rad);
  constexpr double kForceWeight = 1.0 / (kForceSigma_mps2 * kForceSigma_mps2);
  Totals sum;
  const auto add = [&sum](double weight, const Eigen::Vector3d& lidar, const Eigen::Vector3d& imu) {
    sum.profile += weight * lidar * imu.transpose();
    sum.lidar2 += weight * lidar.squaredNorm();
    sum.imu2 += weight * imu.squaredNorm();
  };
  for (const MotionPair& pair : pairs) {
    add(kTurnWeight, pair.turn_by_lidar_rad, scale * pair.turn_by_gyro_rad);
    add(kForceWeight, expected_force(pair, up_in_map), pair.force_mps2);
  }
  return sum;
}

/// Share of what was measured that `rotation` leaves unexplained.
double left_over(const Totals& sum, const Eigen::Matrix3d& rotation) {
  const double squares = sum.lidar2 + sum.imu2 - 2.0 * (rotation * sum.profile.transpose()).trace();
  return std::sqrt(std::max(0.0, squares) / std::max(1e-12, sum.lidar2 + sum.imu2));
}

Eigen::Matrix3d best_rotation(const Eigen::Matrix3d& profile, double determinant) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(profile, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() * determinant;
  return svd.matrixU() * Eigen::Vector3d(1.0, 1.0, sign < 0.0 ? -1.0 : 1.0).asDiagonal() *
         svd.matrixV().transpose();
}

}  // namespace

std::optional<MountingFit> fit_mounting(std::span<const MotionPair> pairs) {
  constexpr std::size_t kMinPairs = 20;
  if (pairs.size() < kMinPairs) return std::nullopt;
  Eigen::Matrix3d turns = Eigen::Matrix3d::Zero();
  double by_gyro2 = 0.0;
  for (const MotionPair& pair : pairs) {
    const Eigen::Vector3d in_map = pair.map_from_imu * pair.turn_by_lidar_rad;
    turns += in_map * in_map.transpose();
    by_gyro2 += pair.turn_by_gyro_rad.squaredNorm();
  }
  const auto count = static_cast<double>(pairs.size());
  if (std::sqrt(turns.trace() / count) < kMinTurnOverSigma * kTurnSigma_rad) return std::nullopt;
  const double ratio = std::sqrt(turns.trace() / std::max(by_gyro2, 1e-18));
  MountingFit best{.error_after = std::numeric_limits<double>::infinity()};
  // A unit other than rad/s shows as a factor far from 1; a good gyro is right to a percent.
  best.gyro_scale = ratio > 1.5 || ratio < 1.0 / 1.5 ? ratio : 1.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(turns);
  Eigen::Vector3d best_up = Eigen::Vector3d::UnitZ();
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector3d up = sign * axes.eigenvectors().col(2);
    const Totals sum = totals(pairs, up, best.gyro_scale);
    for (const double determinant : {1.0, -1.0}) {
      const Eigen::Matrix3d rotation = best_rotation(sum.profile, determinant);
      const double error = left_over(sum, rotation);
      if (!(error < (determinant < 0.0 ? kMirrorGain : 1.0) * best.error_after)) continue;
      best.given_from_measured = rotation;
      best.mirrored = determinant < 0.0;
      best.error_after = error;
      best_up = up;
    }
  }
  best.error_before = left_over(totals(pairs, best_up, 1.0), Eigen::Matrix3d::Identity());
  if (!(best.error_after < kMaxErrorAfter)) return std::nullopt;
  return best;
}

std::string mounting_text(const MountingFit& fit) {
  std::string text;
  if (std::abs(fit.gyro_scale - 1.0) > 1e-9) {
    const double per_degree = std::numbers::pi / 180.0;
    text =
        std::abs(fit.gyro_scale / per_degree - 1.0) < 0.3
            ? "the gyro speaks in degrees, not radians, a second; "
            : fmt::format("the gyro is wrong by a factor of about {:.3g}; ", 1.0 / fit.gyro_scale);
  }
  if (fit.mirrored) return text + "its axes are mirrored (left-handed)";
  const Eigen::AngleAxisd turn(fit.given_from_measured);
  double angle_deg = turn.angle() * 180.0 / std::numbers::pi;
  // Housings are turned by quarters.
  constexpr double kQuarter_deg = 4.0;
  const double quarters = 90.0 * std::round(angle_deg / 90.0);
  if (std::abs(angle_deg - quarters) < kQuarter_deg) angle_deg = quarters;
  constexpr double kNoTurn_deg = 5.0;
  if (angle_deg < kNoTurn_deg) return text + "its axes agree with the LiDAR's";
  for (int i = 0; i < 3; ++i) {
    constexpr double kAlong = 0.97;
    if (std::abs(turn.axis()[i]) < kAlong) continue;
    return text + fmt::format("rotated by about {:.0f} degrees about {}",
                              turn.axis()[i] < 0.0 ? -angle_deg : angle_deg,
                              "xyz"[i]);
  }
  return text + fmt::format("rotated by about {:.0f} degrees about [{:.2f}, {:.2f}, {:.2f}]",
                            angle_deg,
                            turn.axis().x(),
                            turn.axis().y(),
                            turn.axis().z());
}

}  // namespace hybridfusion
