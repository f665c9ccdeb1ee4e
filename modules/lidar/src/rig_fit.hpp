#pragma once

#include "imu_buffer.hpp"

#include <hybridfusion/lidar/odometry.hpp>

#include <array>
#include <span>
#include <vector>

namespace hybridfusion {

/// What the motion of LiDAR and IMU have in common.
struct RigState {
  Rigid3 imu_from_lidar = {};
  double imu_time_offset_s = 0.0;  ///< Added to IMU stamps.
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();
  Eigen::Vector3d gravity_in_map = {0.0, 0.0, -9.81};
};

/// Order of the unknowns of the fit.
namespace rig {
inline constexpr int kRotation = 0;  // imu_from_lidar <- Exp(d) imu_from_lidar: about IMU axes
inline constexpr int kTranslation = 3;
inline constexpr int kOffset = 6;
inline constexpr int kGyroBias = 7;
inline constexpr int kAccelBias = 10;
inline constexpr int kGravity = 13;
inline constexpr int kSize = 16;
inline constexpr int kNumCalibrated = 7;  // rotation, translation, offset
}  // namespace rig
using RigVector = Eigen::Matrix<double, rig::kSize, 1>;
using RigMatrix = Eigen::Matrix<double, rig::kSize, rig::kSize>;

[[nodiscard]] RigState plus(const RigState& state, const RigVector& d);

struct LidarPose {
  Timestamp time{};
  Rigid3 map_from_lidar = {};
  bool usable = true;  ///< Located by its points, from an unbroken IMU stream.
};

struct RigFit {
  RigState state = {};
  RigMatrix covariance = RigMatrix::Zero();  ///< Scaled by the residuals.
  double rms_rotation_rad = 0.0;
  double rms_velocity_mps = 0.0;
};

/// Least squares over all unknowns but the calibrated ones marked in `held`. Rotation rows: the
/// LiDAR's turn over 0.3 s, turned into the IMU, against the gyro. Velocity rows: mean velocities
/// of the IMU over neighbouring seconds against specific force and gravity, as in fit_gravity.
/// @param given  Centre of the weak prior: 0.2 rad, 0.5 m, 0.2 s.
/// @returns kInsufficient below 20 usable rows of either kind.
[[nodiscard]] Expected<RigFit> fit_rig(std::span<const LidarPose> poses,
                                       const ImuBuffer& imu,
                                       const RigState& given,
                                       const RigState& start,
                                       const std::array<bool, rig::kNumCalibrated>& held);

}  // namespace hybridfusion
