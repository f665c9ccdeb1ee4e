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

/// Velocity and gravity at `begin` by least squares from the scan poses of a trial run and the
/// specific force between them; the state is levelled by that gravity. Nothing for fewer than five
/// scans.
[[nodiscard]] std::optional<StateEstimate> fit_moving_state(const StateEstimate& start,
                                                            Timestamp begin,
                                                            std::span<const ScanEstimate> scans,
                                                            const ImuBuffer& imu);

}  // namespace hybridfusion
