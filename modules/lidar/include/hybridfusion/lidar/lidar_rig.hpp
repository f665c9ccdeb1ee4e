#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <cstdint>

#include <Eigen/Core>

namespace hybridfusion {

/// Continuous-time noise of an IMU, as data sheets and Allan plots give it.
struct ImuNoise {
  double gyro_noise_density = 1e-3;   ///< [rad/s/sqrt(Hz)]
  double accel_noise_density = 1e-2;  ///< [m/s^2/sqrt(Hz)]
  double gyro_bias_walk = 2e-5;       ///< [rad/s^2/sqrt(Hz)]
  double accel_bias_walk = 2e-4;      ///< [m/s^3/sqrt(Hz)]
};

/// Whether odometry listens to the IMU.
enum class ImuUse : std::uint8_t {
  kWhereThereIsOne,  ///< Motion comes from the LiDAR alone when no sample arrives.
  kNone              ///< Samples are not looked at.
};

/// What the vehicle knows of itself. The defaults suit a consumer IMU and a LiDAR whose IMU shares
/// its frame.
struct LidarRig {
  Rigid3 imu_from_lidar = {};
  Eigen::Vector3d gnss_antenna_in_imu = Eigen::Vector3d::Zero();  ///< [m]
  ImuNoise imu_noise = {};
  ImuUse imu_use = ImuUse::kWhereThereIsOne;
};

/// kInvalidOptions for a density that is not positive or an extrinsic that is not finite.
[[nodiscard]] Expected<void> validate(const LidarRig& rig);

}  // namespace hybridfusion
