#include "ros_message.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] Eigen::Vector3d read_vector(RosReader& reader) {
  const auto x = reader.read<double>();
  const auto y = reader.read<double>();
  return {x, y, reader.read<double>()};
}

[[nodiscard]] std::unexpected<Error> too_short(std::string_view type, std::size_t bytes) {
  return fail(
      ErrorCode::kParse,
      fmt::format(
          "a {} message of {} bytes ends early; record again if there are many", type, bytes));
}

/// Standard deviation of a variance; 0 for one that says nothing.
[[nodiscard]] double sigma(double variance) {
  return std::isfinite(variance) && variance > 0.0 ? std::sqrt(variance) : 0.0;
}

}  // namespace

RosHeader read_ros_header(RosReader& reader) {
  if (reader.wire() == RosWire::kRos1) reader.skip<std::uint32_t>();  // sequence number
  const auto seconds = reader.read<std::uint32_t>();
  const auto nanoseconds = reader.read<std::uint32_t>();
  return {.stamp = std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds),
          .frame = reader.read_string()};
}

Expected<DecodedImu> decode_imu(std::span<const std::byte> message, RosWire wire) {
  constexpr std::size_t kOrientationAndCovariance = 4 + 9;
  constexpr std::size_t kRestOfCovariance = 8;
  RosReader reader(message, wire);
  DecodedImu imu;
  ImuSample& sample = imu.sample;
  sample.time = read_ros_header(reader).stamp;
  reader.skip<double>(kOrientationAndCovariance);
  const auto read_part = [&reader](Eigen::Vector3d& value) {
    value = read_vector(reader);
    const auto variance = reader.read<double>();
    reader.skip<double>(kRestOfCovariance);
    // Values beside a covariance of -1 are values all the same: some drivers mean "unknown sigma".
    return !value.hasNaN() && !(variance == -1.0 && value.isZero(0.0));
  };
  imu.has_rate = read_part(sample.angular_velocity_radps);
  imu.has_force = read_part(sample.specific_force_mps2);
  // An accelerometer feels gravity or its own noise; three zeros are a field that was not filled.
  imu.has_force = imu.has_force && !sample.specific_force_mps2.isZero(0.0);
  if (reader.failed()) return too_short("sensor_msgs/Imu", message.size());
  if ((imu.has_rate && !sample.angular_velocity_radps.allFinite()) ||
      (imu.has_force && !sample.specific_force_mps2.allFinite())) {
    return fail(ErrorCode::kParse, "an IMU sample is not finite; check the driver");
  }
  return imu;
}

Expected<std::optional<GnssFix>> decode_nav_sat_fix(std::span<const std::byte> message,
                                                    RosWire wire) {
  RosReader reader(message, wire);
  GnssFix fix = {.time = read_ros_header(reader).stamp};
  const auto status = reader.read<std::int8_t>();
  reader.skip<std::uint16_t>();  // service
  fix.position.latitude_deg = reader.read<double>();
  fix.position.longitude_deg = reader.read<double>();
  fix.position.altitude_m = reader.read<double>();
  std::array<double, 9> covariance = {};
  for (double& entry : covariance) entry = reader.read<double>();
  const auto covariance_type = reader.read<std::uint8_t>();
  if (reader.failed()) return too_short("sensor_msgs/NavSatFix", message.size());
  const GeodeticPosition& at = fix.position;
  const bool on_earth = std::abs(at.latitude_deg) <= 90.0 && std::abs(at.longitude_deg) <= 360.0 &&
                        std::abs(at.altitude_m) < 1e5;  // false for NaN
  const bool is_null_island = at.latitude_deg == 0.0 && at.longitude_deg == 0.0;
  constexpr std::int8_t kNoFix = -1;
  if (status <= kNoFix || !on_earth || is_null_island) return std::nullopt;
  if (covariance_type != 0) {
    fix.sigma_enu_m = {sigma(covariance[0]), sigma(covariance[4]), sigma(covariance[8])};
  }
  return fix;
}

}  // namespace hybridfusion
