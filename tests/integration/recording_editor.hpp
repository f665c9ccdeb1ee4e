#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion::testing {

/// A serialised ROS 1 message with its place in the recording.
struct RawMessage {
  std::string topic = {};
  std::string type = {};  ///< "sensor_msgs/Imu"
  std::int64_t recorded_ns = 0;
  std::string data = {};
};

inline constexpr const char* kImuType = "sensor_msgs/Imu";
inline constexpr const char* kCloudType = "sensor_msgs/PointCloud2";
inline constexpr const char* kFixType = "sensor_msgs/NavSatFix";

/// All messages of a ROS 1 bag in the order of recording.
[[nodiscard]] std::vector<RawMessage> read_messages(const std::filesystem::path& bag);
void write_messages(const std::filesystem::path& bag, const std::vector<RawMessage>& messages);

/// Header stamp of a message [ns].
[[nodiscard]] std::int64_t stamp_ns(const RawMessage& message);
void set_stamp(std::int64_t stamp_ns, RawMessage& message);

/// What a sensor_msgs/Imu says [rad/s, m/s^2].
struct ImuValues {
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force = Eigen::Vector3d::Zero();
};
void edit_imu(RawMessage& message, const std::function<void(ImuValues&)>& edit);

/// The bytes of a PointCloud2's points, a row of `step` bytes each, exchanged by `edit` (which may
/// change their number).
void edit_rows(RawMessage& message, const std::function<void(std::vector<std::string>&)>& edit);
/// A float32 field of every point.
void edit_field(RawMessage& message, const std::string& name, const std::function<float(float)>& f);

}  // namespace hybridfusion::testing
