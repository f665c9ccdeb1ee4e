#pragma once

#include "ros_reader.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/sensor_data.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace hybridfusion {

/// Reads a std_msgs/Header and returns its stamp.
[[nodiscard]] Timestamp read_ros_header(RosReader& reader);

/// Serialised sensor_msgs/Imu. @returns kParse when it is too short or a value is not finite.
[[nodiscard]] Expected<ImuSample> decode_imu(std::span<const std::byte> message, RosWire wire);

/// Serialised sensor_msgs/NavSatFix; nothing when the receiver says it has no fix or the
/// position is not one. @returns kParse when it is too short.
[[nodiscard]] Expected<std::optional<GnssFix>> decode_nav_sat_fix(
    std::span<const std::byte> message, RosWire wire);

}  // namespace hybridfusion
