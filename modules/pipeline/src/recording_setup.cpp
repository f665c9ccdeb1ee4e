#include "recording_setup.hpp"

#include <system_error>

namespace hybridfusion {
namespace {

RecordingOptions recording_options(const RecordingOptions& options, const SensorConfig& sensors) {
  RecordingOptions result = options;
  const auto fill = [](std::string& option, const std::optional<std::string>& value) {
    if (option.empty() && value) option = *value;
  };
  fill(result.lidar_topic, sensors.lidar_topic);
  fill(result.imu_topic, sensors.imu_topic);
  fill(result.gnss_topic, sensors.gnss_topic);
  fill(result.point_time_field, sensors.point_time_field);
  fill(result.point_time_unit, sensors.point_time_unit);
  return result;
}

LidarRig rig_of(const SensorConfig& sensors) {
  LidarRig rig;
  rig.imu_from_lidar = sensors.imu_from_lidar.value_or(rig.imu_from_lidar);
  rig.gnss_antenna_in_imu = sensors.gnss_antenna_in_imu.value_or(rig.gnss_antenna_in_imu);
  ImuNoise& noise = rig.imu_noise;
  noise.gyro_noise_density = sensors.gyro_noise_density.value_or(noise.gyro_noise_density);
  noise.accel_noise_density = sensors.accel_noise_density.value_or(noise.accel_noise_density);
  noise.gyro_bias_walk = sensors.gyro_bias_walk.value_or(noise.gyro_bias_walk);
  noise.accel_bias_walk = sensors.accel_bias_walk.value_or(noise.accel_bias_walk);
  return rig;
}

}  // namespace

Expected<RecordingSetup> recording_setup(const LidarStageOptions& options,
                                         const std::filesystem::path& bag,
                                         const std::optional<std::filesystem::path>& sensors) {
  RecordingSetup setup{.sensors_path = sensors, .odometry = options.odometry};
  std::error_code code;
  const std::filesystem::path beside = bag.parent_path() / "sensors.yaml";
  if (!sensors && std::filesystem::is_regular_file(beside, code)) setup.sensors_path = beside;
  if (setup.sensors_path) {
    HF_TRY(setup.sensors, read_sensors_yaml(*setup.sensors_path));
  }
  setup.recording = recording_options(options.recording, setup.sensors);
  setup.rig = rig_of(setup.sensors);
  if (setup.odometry.imu_time_offset_s == 0.0) {
    setup.odometry.imu_time_offset_s = setup.sensors.imu_time_offset_s.value_or(0.0);
  }
  return setup;
}

}  // namespace hybridfusion
