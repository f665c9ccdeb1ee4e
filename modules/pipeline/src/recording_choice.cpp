#include "recording_choice.hpp"

#include <system_error>

namespace hybridfusion {

RecordingOptions recording_options(const RecordingOptions& options, const SensorConfig& sensors) {
  RecordingOptions result = options;
  const auto fill = [](std::string& option, const std::optional<std::string>& value) {
    if (option.empty() && value) option = *value;
  };
  fill(result.lidar_topic, sensors.lidar_topic);
  fill(result.imu_topic, sensors.imu_topic);
  fill(result.gnss_topic, sensors.gnss_topic);
  fill(result.lidar_frame, sensors.lidar_frame);
  fill(result.imu_frame, sensors.imu_frame);
  fill(result.point_time_field, sensors.point_time_field);
  fill(result.point_time_unit, sensors.point_time_unit);
  return result;
}

std::optional<std::filesystem::path> sensors_file(
    const std::filesystem::path& bag, const std::optional<std::filesystem::path>& given) {
  if (given) return given;
  constexpr std::string_view kName = "sensors.yaml";
  for (const std::filesystem::path& candidate : {bag / kName, bag.parent_path() / kName}) {
    std::error_code code;
    if (std::filesystem::is_regular_file(candidate, code)) return candidate;
  }
  return std::nullopt;
}

}  // namespace hybridfusion
