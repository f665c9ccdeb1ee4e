#pragma once

/// @file
/// Messages of ROS 2 for tests, written from the description of CDR, independent of the reader.

#include "bag_builder.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion::testing {

/// Serialises for ROS 2: CDR aligns each value to its size, behind a header of four bytes.
class CdrWriter {
 public:
  template <class T>
  void put_value(T value) {
    while (body_.size() % sizeof(T) != 0) body_ += '\0';
    put(body_, value);
  }
  void put_text(std::string_view text) {
    put_value(static_cast<std::uint32_t>(text.size() + 1));
    body_ += text;
    body_ += '\0';
  }
  void put_bytes(std::string_view bytes) { body_ += bytes; }
  void put_header(std::int64_t stamp_ns) {
    put_value(static_cast<std::int32_t>(stamp_ns / 1'000'000'000));
    put_value(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000));
    put_text("frame");
  }
  [[nodiscard]] std::string message() const { return std::string("\0\1\0\0", 4) + body_; }

 private:
  std::string body_ = {};
};

[[nodiscard]] inline std::string imu_cdr(std::int64_t stamp_ns, double gyro_x, double accel_z) {
  CdrWriter out;
  out.put_header(stamp_ns);
  for (int i = 0; i < 4 + 9; ++i) out.put_value(0.0);
  for (const double value : {gyro_x, 0.0, 0.0}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(0.0);
  for (const double value : {0.0, 0.0, accel_z}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(0.0);
  return out.message();
}

[[nodiscard]] inline std::string fix_cdr(std::int64_t stamp_ns,
                                         double latitude_deg,
                                         double variance) {
  CdrWriter out;
  out.put_header(stamp_ns);
  out.put_value(std::int8_t{0});
  out.put_value(std::uint16_t{1});
  for (const double value : {latitude_deg, 11.5, 520.0}) out.put_value(value);
  for (int i = 0; i < 9; ++i) out.put_value(i % 4 == 0 ? variance : 0.0);
  out.put_value(std::uint8_t{2});
  return out.message();
}

/// x, y, z, time as float32.
[[nodiscard]] inline std::string cloud_cdr(std::int64_t stamp_ns,
                                           const std::vector<std::vector<double>>& points) {
  CdrWriter out;
  out.put_header(stamp_ns);
  out.put_value(std::uint32_t{1});
  out.put_value(static_cast<std::uint32_t>(points.size()));
  out.put_value(std::uint32_t{4});
  std::uint32_t offset = 0;
  for (const char* const name : {"x", "y", "z", "time"}) {
    out.put_text(name);
    out.put_value(offset);
    out.put_value(std::uint8_t{7});
    out.put_value(std::uint32_t{1});
    offset += 4;
  }
  out.put_value(std::uint8_t{0});
  out.put_value(offset);
  out.put_value(static_cast<std::uint32_t>(offset * points.size()));
  std::string data;
  for (const std::vector<double>& point : points) {
    for (const double value : point) put(data, static_cast<float>(value));
  }
  out.put_value(static_cast<std::uint32_t>(data.size()));
  out.put_bytes(data);
  out.put_value(std::uint8_t{1});
  return out.message();
}

}  // namespace hybridfusion::testing
