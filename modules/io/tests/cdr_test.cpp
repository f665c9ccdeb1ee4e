#include "ros_message.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

// Messages serialised by @foxglove/rosmsg2-serialization, stamp 1700000000.000000005, frame "ab".
constexpr std::string_view kFix =
    "0001000000f153650500000003000000616200000100000000000000000000000040484000000000"
    "00002740000000000040804000000000000010400000000000000000000000000000000000000000"
    "00000000000000000000104000000000000000000000000000000000000000000000000000000000"
    "0000224002";
constexpr std::string_view kImu =
    "0001000000f153650500000003000000616200000000000000000000000000000000000000000000"
    "00000000000000000000f03f00000000000000000000000000000000000000000000000000000000"
    "00000000000000000000000000000000000000000000000000000000000000000000000000000000"
    "000000009a9999999999b93f9a9999999999c93f333333333333d33f000000000000000000000000"
    "00000000000000000000000000000000000000000000000000000000000000000000000000000000"
    "0000000000000000000000000000000000000000000000000000f03f00000000000000401f85eb51"
    "b89e2340000000000000000000000000000000000000000000000000000000000000000000000000"
    "000000000000000000000000000000000000000000000000000000000000000000000000";
constexpr std::string_view kCloud =
    "0001000000f153650500000003000000616200000100000002000000040000000200000078000000"
    "0000000007000000010000000200000079000000040000000700000001000000020000007a000000"
    "0800000007000000010000000500000074696d65000000000c000000070000000100000000000000"
    "1000000020000000200000000000803f00000040000040400ad7233c000080400000a0400000c040"
    "0ad7a33c01";
constexpr std::string_view kLivox =
    "0001000000f153650500000003000000616200000700000000000000020000000000000002000000"
    "0a0000000000803f000000400000404009100200002d3101000080400000a0400000c040080003";

constexpr Timestamp kStamp{1'700'000'000'000'000'005};

std::vector<std::byte> bytes_of(std::string_view hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(digit(hex[i]) * 16 + digit(hex[i + 1])));
  }
  return bytes;
}

TEST(Cdr, ReadsWhatAnIndependentWriterSerialised) {
  const auto fix = decode_nav_sat_fix(bytes_of(kFix), RosWire::kCdr);
  ASSERT_TRUE(fix && *fix);
  EXPECT_EQ((*fix)->time, kStamp);
  EXPECT_EQ((*fix)->position.latitude_deg, 48.5);
  EXPECT_EQ((*fix)->position.altitude_m, 520.0);
  EXPECT_EQ((*fix)->sigma_enu_m, Eigen::Vector3d(2, 2, 3));
  const auto imu = decode_imu(bytes_of(kImu), RosWire::kCdr);
  ASSERT_TRUE(imu);
  EXPECT_EQ(imu->sample.time, kStamp);
  EXPECT_EQ(imu->sample.angular_velocity_radps, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(imu->sample.specific_force_mps2, Eigen::Vector3d(1, 2, 9.81));
  ScanDecoder decoder;
  const auto cloud = decoder.decode_point_cloud2(bytes_of(kCloud), RosWire::kCdr);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->stamp, kStamp);
  ASSERT_EQ(cloud->points.size(), 2U);
  EXPECT_EQ(cloud->points[1].point_in_lidar, Eigen::Vector3f(4, 5, 6));
  ScanDecoder livox_decoder;
  const auto livox = livox_decoder.decode_livox(bytes_of(kLivox), RosWire::kCdr);
  ASSERT_TRUE(livox);
  ASSERT_EQ(livox->points.size(), 2U);
  EXPECT_EQ(livox->points[0].point_in_lidar, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(livox->points[1].point_in_lidar, Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(livox->points[1].intensity, 8.0F);
  EXPECT_EQ(livox->points[1].ring, 3);
}

TEST(Cdr, ReadsBigEndianMessages) {
  // The fix again, every number reversed by hand where it stands.
  std::vector<std::byte> bytes = bytes_of(kFix);
  bytes[1] = std::byte{0};
  const auto reverse = [&bytes](std::size_t at, std::size_t size) {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(4 + at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(4 + at + size));
  };
  for (const std::size_t at : {0U, 4U, 8U}) reverse(at, 4);
  reverse(16 + 2, 2);  // service, behind the status and one byte of padding
  for (std::size_t at = 24; at < 24 + 12 * 8; at += 8) reverse(at, 8);
  const auto fix = decode_nav_sat_fix(bytes, RosWire::kCdr);
  ASSERT_TRUE(fix && *fix);
  EXPECT_EQ((*fix)->time, kStamp);
  EXPECT_EQ((*fix)->position.latitude_deg, 48.5);
  EXPECT_EQ((*fix)->sigma_enu_m, Eigen::Vector3d(2, 2, 3));
}

TEST(Cdr, ShortAndForeignMessagesAreErrors) {
  const std::vector<std::byte> good = bytes_of(kImu);
  for (std::size_t size = 0; size < good.size() - 9 * 8; ++size) {
    const auto cut = decode_imu(std::span(good).first(size), RosWire::kCdr);
    ASSERT_FALSE(cut) << size;
    EXPECT_EQ(cut.error().code, ErrorCode::kParse);
  }
  std::vector<std::byte> version2 = good;
  version2[1] = std::byte{7};  // PLAIN_CDR2, aligned differently
  EXPECT_FALSE(decode_imu(version2, RosWire::kCdr));
  for (const std::string_view message : {kCloud, kLivox}) {
    const std::vector<std::byte> whole = bytes_of(message);
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
      ScanDecoder decoder;
      const auto bytes = std::span(whole).first(size);
      const auto scan = message == kCloud ? decoder.decode_point_cloud2(bytes, RosWire::kCdr)
                                          : decoder.decode_livox(bytes, RosWire::kCdr);
      EXPECT_FALSE(scan) << size;
    }
  }
}

}  // namespace
}  // namespace hybridfusion
