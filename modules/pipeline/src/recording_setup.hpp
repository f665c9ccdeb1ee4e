#pragma once

#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/lidar/lidar_rig.hpp>
#include <hybridfusion/lidar/odometry_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <filesystem>
#include <optional>

namespace hybridfusion {

/// What is known of a recording before it is read: options that are set win over sensors.yaml,
/// which wins over detection and defaults.
struct RecordingSetup {
  std::optional<std::filesystem::path> sensors_path = {};
  SensorConfig sensors = {};
  RecordingOptions recording = {};
  OdometryOptions odometry = {};
  LidarRig rig = {};
};

/// @param sensors  Absent: sensors.yaml beside the recording when it exists. Scratch files go to
/// the
///                 workspace unless an option names another folder.
/// @returns what reading sensors.yaml returns.
[[nodiscard]] Expected<RecordingSetup> recording_setup(
    const Project& project,
    const std::filesystem::path& bag,
    const std::optional<std::filesystem::path>& sensors);

}  // namespace hybridfusion
