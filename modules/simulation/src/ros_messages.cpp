#include "ros_messages.hpp"

namespace hybridfusion {
namespace {

constexpr std::uint8_t kLivoxTag = 0x10;  // Strongest return, no noise flags.

void put_header(ByteWriter& out, const RosHeader& header) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  out.put(header.sequence);
  out.put(static_cast<std::uint32_t>(header.stamp.count() / kSecond));
  out.put(static_cast<std::uint32_t>(header.stamp.count() % kSecond));
  out.put_sized(header.frame);
}

void put_diagonal(ByteWriter& out, const Eigen::Vector3d& diagonal) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out.put(row == column ? diagonal[row] : 0.0);
  }
}

struct PointField {
  std::string_view name;
  std::uint32_t offset;
  std::uint8_t type;  // sensor_msgs/PointField: 2 uint8, 4 uint16, 6 uint32, 7 float32
};

}  // namespace

std::string imu_message(const RosHeader& header,
                        const ImuSample& sample,
                        double gyro_variance,
                        double accel_variance) {
  ByteWriter out;
  put_header(out, header);
  for (const double value : {0.0, 0.0, 0.0, 1.0}) out.put(value);
  // -1 in the first element: there is no orientation.
  out.put(-1.0);
  for (int i = 1; i < 9; ++i) out.put(0.0);
  for (int i = 0; i < 3; ++i) out.put(sample.angular_velocity_radps[i]);
  put_diagonal(out, Eigen::Vector3d::Constant(gyro_variance));
  for (int i = 0; i < 3; ++i) out.put(sample.specific_force_mps2[i]);
  put_diagonal(out, Eigen::Vector3d::Constant(accel_variance));
  return out.take();
}

std::string nav_sat_fix_message(const RosHeader& header,
                                const GeodeticPosition& position,
                                const Eigen::Vector3d& sigma_enu_m,
                                bool rtk) {
  constexpr std::int8_t kStatusFix = 0;
  constexpr std::int8_t kStatusGroundAugmented = 2;
  constexpr std::uint16_t kServiceGps = 1;
  constexpr std::uint8_t kCovarianceDiagonal = 2;
  ByteWriter out;
  put_header(out, header);
  out.put(rtk ? kStatusGroundAugmented : kStatusFix);
  out.put(kServiceGps);
  out.put(position.latitude_deg);
  out.put(position.longitude_deg);
  out.put(position.altitude_m);
  put_diagonal(out, sigma_enu_m.cwiseAbs2());
  out.put(kCovarianceDiagonal);
  return out.take();
}

std::string point_cloud2_message(const RosHeader& header,
                                 std::span<const LidarReturn> points,
                                 bool livox) {
  constexpr std::uint32_t kPointStep = 22;
  std::vector<PointField> fields = {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}, {"intensity", 12, 7}};
  if (livox) {
    fields.insert(fields.end(), {{"tag", 16, 2}, {"line", 17, 2}, {"offset_time", 18, 6}});
  } else {
    fields.insert(fields.end(), {{"ring", 16, 4}, {"time", 18, 7}});
  }
  const auto count = static_cast<std::uint32_t>(points.size());
  ByteWriter out;
  out.reserve(256 + std::size_t{kPointStep} * count);
  put_header(out, header);
  out.put(std::uint32_t{1});  // height
  out.put(count);
  out.put(static_cast<std::uint32_t>(fields.size()));
  for (const PointField& field : fields) {
    out.put_sized(field.name);
    out.put(field.offset);
    out.put(field.type);
    out.put(std::uint32_t{1});
  }
  out.put(std::uint8_t{0});  // little-endian
  out.put(kPointStep);
  out.put(kPointStep * count);
  out.put(kPointStep * count);
  for (const LidarReturn& point : points) {
    for (int i = 0; i < 3; ++i) out.put(point.point[i]);
    out.put(point.intensity);
    if (livox) {
      out.put(kLivoxTag);
      out.put(static_cast<std::uint8_t>(point.ring));
      out.put(static_cast<std::uint32_t>(point.offset_ns));
    } else {
      out.put(point.ring);
      out.put(static_cast<float>(1e-9 * point.offset_ns));
    }
  }
  out.put(std::uint8_t{1});  // is_dense
  return out.take();
}

std::string livox_message(const RosHeader& header, std::span<const LidarReturn> points) {
  const auto count = static_cast<std::uint32_t>(points.size());
  ByteWriter out;
  put_header(out, header);
  out.put(static_cast<std::uint64_t>(header.stamp.count()));
  out.put(count);
  for (int i = 0; i < 4; ++i) out.put(std::uint8_t{0});  // lidar_id, rsvd[3]
  out.put(count);
  for (const LidarReturn& point : points) {
    out.put(static_cast<std::uint32_t>(point.offset_ns));
    for (int i = 0; i < 3; ++i) out.put(point.point[i]);
    out.put(static_cast<std::uint8_t>(point.intensity));
    out.put(kLivoxTag);
    out.put(static_cast<std::uint8_t>(point.ring));
  }
  return out.take();
}

std::string compressed_image_message(const RosHeader& header, std::string_view jpeg) {
  ByteWriter out;
  put_header(out, header);
  out.put_sized("jpeg");
  out.put_sized(jpeg);
  return out.take();
}

}  // namespace hybridfusion
