#pragma once

#include "ros_reader.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/sensor_data.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace hybridfusion {

/// A std_msgs/Header.
struct RosHeader {
  Timestamp stamp{};
  std::string_view frame = {};  ///< frame_id, part of the message that was read.
};
[[nodiscard]] RosHeader read_ros_header(RosReader& reader);

/// A sample and what of it was measured: drivers that send rate and acceleration apart leave the
/// other one NaN, or 0 with -1 in its covariance (sensor_msgs/Imu).
struct DecodedImu {
  ImuSample sample = {};
  bool has_rate = true;
  bool has_force = true;
};

/// Serialised sensor_msgs/Imu. @returns kParse when it is too short or a value is infinite.
[[nodiscard]] Expected<DecodedImu> decode_imu(std::span<const std::byte> message, RosWire wire);

/// Serialised sensor_msgs/NavSatFix; nothing when the receiver says it has no fix or the
/// position is not one. @returns kParse when it is too short.
[[nodiscard]] Expected<std::optional<GnssFix>> decode_nav_sat_fix(
    std::span<const std::byte> message, RosWire wire);

}  // namespace hybridfusion
