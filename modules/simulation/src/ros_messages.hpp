#pragma once

#include "bag_writer.hpp"
#include "lidar_model.hpp"

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/sensor_data.hpp>

#include <span>
#include <string>

namespace hybridfusion {

extern const RosMessageType kImuMessage;
extern const RosMessageType kNavSatFixMessage;
extern const RosMessageType kPointCloud2Message;
extern const RosMessageType kLivoxMessage;
extern const RosMessageType kCompressedImageMessage;

/// std_msgs/Header of a message.
struct RosHeader {
  std::uint32_t sequence = 0;
  Timestamp stamp{};
  std::string_view frame = {};
};

[[nodiscard]] std::string imu_message(const RosHeader& header,
                                      const ImuSample& sample,
                                      double gyro_variance,
                                      double accel_variance);
[[nodiscard]] std::string nav_sat_fix_message(const RosHeader& header,
                                              const GeodeticPosition& position,
                                              const Eigen::Vector3d& sigma_enu_m,
                                              bool rtk);
/// x y z intensity (float32) and, for a spinning LiDAR, ring (uint16) and time (float32, s after
/// the stamp); for a Livox tag, line (uint8) and offset_time (uint32, ns).
[[nodiscard]] std::string point_cloud2_message(const RosHeader& header,
                                               std::span<const LidarReturn> points,
                                               bool livox);
/// livox_ros_driver/CustomMsg.
[[nodiscard]] std::string livox_message(const RosHeader& header,
                                        std::span<const LidarReturn> points);
[[nodiscard]] std::string compressed_image_message(const RosHeader& header, std::string_view jpeg);

}  // namespace hybridfusion
