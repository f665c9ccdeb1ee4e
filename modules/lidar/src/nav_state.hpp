#pragma once

#include "manifold.hpp"

#include <hybridfusion/core/rigid3.hpp>

#include <Eigen/Core>

namespace hybridfusion {

/// Order of the error state: first row of each block.
namespace err {
inline constexpr int kPosition = 0;
inline constexpr int kRotation = 3;
inline constexpr int kVelocity = 6;
inline constexpr int kGyroBias = 9;
inline constexpr int kAccelBias = 12;
inline constexpr int kGravity = 15;            // 2 numbers, on S2
inline constexpr int kExtrinsicPosition = 17;  // held at zero variance unless it is estimated
inline constexpr int kExtrinsicRotation = 20;
inline constexpr int kSize = 23;
}  // namespace err

using ErrorVector = Eigen::Matrix<double, err::kSize, 1>;
using ErrorMatrix = Eigen::Matrix<double, err::kSize, err::kSize>;

/// State of the filter: R3 x SO(3) x R3 x R3 x R3 x S2 x SE(3).
struct NavState {
  Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();     ///< Of the IMU [m].
  Eigen::Matrix3d map_from_imu = Eigen::Matrix3d::Identity();    ///< Rotation.
  Eigen::Vector3d velocity_in_map = Eigen::Vector3d::Zero();     ///< [m/s]
  Eigen::Vector3d gyro_bias = Eigen::Vector3d::Zero();           ///< [rad/s]
  Eigen::Vector3d accel_bias = Eigen::Vector3d::Zero();          ///< [m/s^2]
  Eigen::Vector3d gravity_in_map = {0.0, 0.0, -9.81};            ///< Constant length [m/s^2].
  Eigen::Vector3d lidar_in_imu = Eigen::Vector3d::Zero();        ///< [m]
  Eigen::Matrix3d imu_from_lidar = Eigen::Matrix3d::Identity();  ///< Rotation.

  [[nodiscard]] Rigid3 pose() const;
};

[[nodiscard]] NavState plus(const NavState& state, const ErrorVector& error);
/// The error with plus(from, error) = to.
[[nodiscard]] ErrorVector minus(const NavState& to, const NavState& from);
/// d minus(plus(plus(prior, deviation), e), prior) / de inverted: takes errors about the prior to
/// errors about the state `deviation` away from it.
[[nodiscard]] ErrorMatrix transport(const NavState& prior, const ErrorVector& deviation);

}  // namespace hybridfusion
