#pragma once

/// @file
/// PointCloud2 messages for the tests of their decoder.

#include "bag_builder.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion::testing {

constexpr std::int64_t kStamp_ns = 1'777'674'600'050'000'000;
constexpr double kStamp_s = 1'777'674'600.05;

/// Data types of sensor_msgs/PointField.
constexpr std::uint8_t kU8 = 2;
constexpr std::uint8_t kU16 = 4;
constexpr std::uint8_t kU32 = 6;
constexpr std::uint8_t kF32 = 7;
constexpr std::uint8_t kF64 = 8;

[[nodiscard]] inline std::span<const std::byte> bytes_of(const std::string& message) {
  return std::as_bytes(std::span(message));
}

/// 100 points with the given time values at 0, 1, ... 99 per cent of a 0.1 s scan.
[[nodiscard]] inline std::string timed_scan(const std::string& field,
                                            std::uint8_t datatype,
                                            double first,
                                            double unit_per_s,
                                            bool big_endian = false) {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 100; ++i) {
    points.push_back({1.0 + i, 2.0, 3.0, first + i * 0.001 * unit_per_s});
  }
  return cloud_message(
      kStamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}, {field, datatype}}, points, big_endian);
}

}  // namespace hybridfusion::testing
