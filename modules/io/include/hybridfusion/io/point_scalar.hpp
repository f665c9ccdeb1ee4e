#pragma once

#include <hybridfusion/core/point_cloud.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hybridfusion {

/// Number types of point fields, in the order of sensor_msgs/PointField (which counts from 1).
enum class ScalarType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64,
  kInt64,  ///< Not in PointField.
  kUint64
};

/// A scalar of the points beside the channels of a cloud: a class, a return number, extra bytes.
/// Those of LAS have the names classification, return_number, number_of_returns, scan_direction,
/// edge_of_flight_line, synthetic, key_point, overlap, scanner_channel, scan_angle [deg],
/// user_data, point_source_id, gps_time and near_infrared.
struct PointScalar {
  std::string name = {};
  ScalarType type = ScalarType::kFloat64;  ///< That holds all values.
  std::string description = {};
  std::vector<double> values = {};  ///< As many as points.
};

/// Points of a file with everything that the file says of them.
struct CloudBatch : PointCloud {
  std::vector<PointScalar> scalars = {};
};

/// `b` behind `a`, which has the same channels and scalars or is empty.
void append(CloudBatch& a, CloudBatch b);

/// Where the sensor stood, as PCD files say it: translation [m], quaternion w x y z.
using Viewpoint = std::array<double, 7>;
inline constexpr Viewpoint kNoViewpoint = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};

}  // namespace hybridfusion
