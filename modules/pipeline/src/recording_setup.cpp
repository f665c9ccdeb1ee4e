#include "recording_setup.hpp"

#include "recording_choice.hpp"

#include <hybridfusion/pipeline/pipeline_options.hpp>

namespace hybridfusion {
namespace {

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

Expected<RecordingSetup> recording_setup(const Project& project,
                                         const std::filesystem::path& bag,
                                         const std::optional<std::filesystem::path>& sensors) {
  const LidarStageOptions& options = project.options.lidar;
  RecordingSetup setup{.sensors_path = sensors_file(bag, sensors), .odometry = options.odometry};
  if (setup.sensors_path) {
    HF_TRY(setup.sensors, read_sensors_yaml(*setup.sensors_path));
  }
  setup.recording = recording_options(options.recording, setup.sensors);
  if (setup.recording.scratch_folder.empty()) {
    setup.recording.scratch_folder = project.workspace.root().string();
  }
  setup.rig = rig_of(setup.sensors);
  if (options.imu == "none") {
    setup.recording.imu_topic = "none";
    setup.rig.imu_use = ImuUse::kNone;
  }
  if (setup.odometry.imu_time_offset_s == 0.0) {
    setup.odometry.imu_time_offset_s = setup.sensors.imu_time_offset_s.value_or(0.0);
  }
  return setup;
}

}  // namespace hybridfusion
