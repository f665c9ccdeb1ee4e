#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/io/ros_wire.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// How the time of each point is found in a scan message; empty strings mean "detect".
struct PointTimeOptions {
  std::string field = {};  ///< Name of the PointCloud2 field; "none": synthesise.
  std::string unit = {};   ///< "s", "ms", "us", "ns".
};

class PointTimeReader;

/// Decodes the scans of one topic, sensor_msgs/PointCloud2 or Livox CustomMsg (v1 and v2 have the
/// same layout). Keeps what it found out about the point times from the first telling scan on, so
/// that one odd scan does not change the unit. Times absent or all the same are synthesised from
/// the azimuth (spinning LiDAR) or the order of the points, with a warning.
class ScanDecoder {
 public:
  explicit ScanDecoder(PointTimeOptions options = {});
  ScanDecoder(ScanDecoder&&) noexcept;
  ScanDecoder& operator=(ScanDecoder&&) noexcept;
  ~ScanDecoder();

  /// @param message  Serialised sensor_msgs/PointCloud2.
  /// @returns Points in message order; those that Livox tags as noise are left out. kParse for
  /// bytes that contradict the declared layout, kNotFound without x y z or the time field asked
  /// for.
  [[nodiscard]] Expected<LidarScan> decode_point_cloud2(std::span<const std::byte> message,
                                                        RosWire wire = RosWire::kRos1);
  /// @param message  Serialised point_cloud_interfaces/CompressedPointCloud2 of
  /// point_cloud_transport. @returns kNotFound for a compression other than zstd.
  [[nodiscard]] Expected<LidarScan> decode_compressed(std::span<const std::byte> message,
                                                      RosWire wire = RosWire::kCdr);
  /// @param message  Serialised livox_ros_driver(2)/CustomMsg.
  [[nodiscard]] Expected<LidarScan> decode_livox(std::span<const std::byte> message,
                                                 RosWire wire = RosWire::kRos1);

  /// How point times are found, for a person: "field 'time' (float32, s, relative to the scan's
  /// stamp)"; empty before the first scan.
  [[nodiscard]] const std::string& point_time() const;
  /// Whether times were made up for any scan so far.
  [[nodiscard]] bool made_up() const;
  /// Things worth telling since the last call; each is told once.
  [[nodiscard]] std::vector<std::string> take_warnings();

 private:
  std::unique_ptr<PointTimeReader> times_;
};

}  // namespace hybridfusion
