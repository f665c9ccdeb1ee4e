#pragma once

#include "nav_state.hpp"

#include <hybridfusion/lidar/odometry.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Constant IMU input over a short interval: the mid-point of the samples at its ends.
struct ImuStep {
  /// No IMU speaks: velocity in the map and turn rate (the negative gyro bias) go on, and noise of
  /// the motion itself takes the place of the sensor's.
  bool coasting = false;
  double dt_s = 0.0;
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();
  bool bridged = false;    ///< Interpolated over a gap or held beyond the samples.
  bool held = false;       ///< Beyond the samples: the nearest one repeated.
  bool saturated = false;  ///< A channel stood at its limit.
};

struct StateEstimate {
  NavState state = {};
  ErrorMatrix covariance = ErrorMatrix::Zero();
};

/// Mid-point integration: rotation at half the step turns the specific force, position takes the
/// 1/2 a dt^2 term. Exactly undone by `propagated_back`.
[[nodiscard]] NavState propagated(const NavState& state, const ImuStep& step);
[[nodiscard]] NavState propagated_back(const NavState& state, const ImuStep& step);

/// d propagated / d state in error coordinates.
[[nodiscard]] ErrorMatrix propagation_jacobian(const NavState& state, const ImuStep& step);

/// State and covariance over `step`; the noise densities are continuous, so the result does not
/// depend on how an interval is cut into steps (to first order).
void propagate(const ImuStep& step, const ImuNoise& noise, StateEstimate& estimate);

/// Appends `step`, with the accelerometer bias left in it.
void integrate(const ImuStep& step, const Eigen::Vector3d& gyro_bias, ImuIncrement& increment);

/// Motion within a scan: the state at the start of each step and the input that holds until the
/// next.
struct PathNode {
  double time_s = 0.0;  ///< Relative to the end of the path, <= 0.
  Eigen::Matrix3d map_from_imu = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_in_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_in_map = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
};

/// The path that ends in `end` after `steps`, in ascending time (one node a step).
[[nodiscard]] std::vector<PathNode> path_before(const NavState& end,
                                                std::span<const ImuStep> steps);

}  // namespace hybridfusion
