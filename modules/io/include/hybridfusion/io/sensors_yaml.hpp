#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// What a vehicle knows of itself (sensors.yaml). Absent keys are empty: topics and the point-time
/// field are then detected, the rest has defaults in the module that uses it.
struct SensorConfig {
  std::optional<std::string> lidar_topic = {};
  std::optional<std::string> imu_topic = {};
  std::optional<std::string> gnss_topic = {};
  std::optional<std::string> lidar_frame = {};  ///< frame_id, where several share a topic.
  std::optional<std::string> imu_frame = {};
  std::optional<std::string> point_time_field = {};
  std::optional<std::string> point_time_unit = {};  ///< s, ms, us or ns.
  std::optional<Rigid3> imu_from_lidar = {};        ///< 16 numbers, row-major.
  std::optional<double> imu_time_offset_s = {};     ///< Added to IMU stamps: onto the LiDAR clock.
  std::optional<Eigen::Vector3d> gnss_antenna_in_imu = {};  ///< [m]
  std::optional<double> gyro_noise_density = {};            ///< [rad/s/sqrt(Hz)]
  std::optional<double> accel_noise_density = {};           ///< [m/s^2/sqrt(Hz)]
  std::optional<double> gyro_bias_walk = {};                ///< [rad/s^2/sqrt(Hz)]
  std::optional<double> accel_bias_walk = {};               ///< [m/s^3/sqrt(Hz)]
};

/// @returns kNotFound; kInvalidOptions with the line for an unknown key or a value out of range;
/// kParse with the line for a value of another type.
[[nodiscard]] Expected<SensorConfig> read_sensors_yaml(const std::filesystem::path& path);

/// The text of a sensors.yaml that reads back as `config`; absent values are left out.
[[nodiscard]] std::string to_yaml(const SensorConfig& config);

}  // namespace hybridfusion
