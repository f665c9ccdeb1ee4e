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

Timestamp read_ros_header(RosReader& reader) {
  if (reader.wire() == RosWire::kRos1) reader.skip<std::uint32_t>();  // sequence number
  const auto seconds = reader.read<std::uint32_t>();
  const auto nanoseconds = reader.read<std::uint32_t>();
  static_cast<void>(reader.read_string());  // frame id
  return std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds);
}

Expected<ImuSample> decode_imu(std::span<const std::byte> message, RosWire wire) {
  constexpr std::size_t kOrientationAndCovariance = 4 + 9;
  constexpr std::size_t kCovariance = 9;
  RosReader reader(message, wire);
  ImuSample sample = {.time = read_ros_header(reader)};
  reader.skip<double>(kOrientationAndCovariance);
  sample.angular_velocity_radps = read_vector(reader);
  reader.skip<double>(kCovariance);
  sample.specific_force_mps2 = read_vector(reader);
  if (reader.failed()) return too_short("sensor_msgs/Imu", message.size());
  if (!sample.angular_velocity_radps.allFinite() || !sample.specific_force_mps2.allFinite()) {
    return fail(ErrorCode::kParse, "an IMU sample is not finite; check the driver");
  }
  return sample;
}

Expected<std::optional<GnssFix>> decode_nav_sat_fix(std::span<const std::byte> message,
                                                    RosWire wire) {
  RosReader reader(message, wire);
  GnssFix fix = {.time = read_ros_header(reader)};
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
