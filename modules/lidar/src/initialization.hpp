#pragma once

#include "imu_buffer.hpp"
#include "scan_filter.hpp"

#include <optional>
#include <span>

namespace hybridfusion {

inline constexpr double kStandardGravity_mps2 = 9.80665;

/// Averages of the IMU over a time window.
struct ImuMean {
  std::size_t num_samples = 0;
  double duration_s = 0.0;
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();
  double gyro_std_radps = 0.0;  ///< Largest of the axes.
  double accel_std_mps2 = 0.0;
};
[[nodiscard]] ImuMean imu_mean(const ImuBuffer& imu, Timestamp begin, Timestamp end);

[[nodiscard]] bool is_standstill(const ImuMean& mean,
                                 const LidarInitOptions& options,
                                 const ImuNoise& noise);

/// True when the specific force is about 1 at rest: the IMU speaks in g.
[[nodiscard]] bool speaks_in_g(const ImuMean& mean);

/// Level attitude, zero velocity, gyro bias from the mean. Accelerometer bias and gravity are each
/// uncertain, but what they add up to is known from the mean: their covariance says so.
/// @param velocity_sigma_mps  How far the vehicle may be from standing still.
[[nodiscard]] StateEstimate standstill_state(const ImuMean& mean,
                                             const LidarRig& rig,
                                             double velocity_sigma_mps);
/// As good a guess as the IMU alone allows when the vehicle moves.
[[nodiscard]] StateEstimate moving_state(const ImuMean& mean, const LidarRig& rig);

/// State at `begin` from scan poses that owe nothing to the IMU and from what the IMU measured
/// meanwhile: gyro bias from the turns, velocity and gravity by least squares; the map is levelled
/// by that gravity. Nothing for fewer than five scans, or when no gravity is in the force.
/// @param scans  Poses in the frame of the IMU at `begin`.
[[nodiscard]] std::optional<StateEstimate> fit_moving_state(std::span<const ScanEstimate> scans,
                                                            Timestamp begin,
                                                            const ImuBuffer& imu,
                                                            const LidarRig& rig);

}  // namespace hybridfusion
