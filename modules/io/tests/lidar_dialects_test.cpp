#include "bag_builder.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::int64_t kStamp_ns = 1'777'674'600'050'000'000;
constexpr double kStamp_s = 1'777'674'600.05;
constexpr int kPoints = 200;
constexpr std::uint8_t kU8 = 2;
constexpr std::uint8_t kU16 = 4;
constexpr std::uint8_t kU32 = 6;
constexpr std::uint8_t kF32 = 7;
constexpr std::uint8_t kF64 = 8;

/// The point layout of a driver, gaps as it leaves them.
struct Dialect {
  std::string name = {};
  std::vector<testing::TestField> fields = {};
  std::string time_field = {};
  double first_time = 0.0;
  double unit_per_s = 1.0;
  std::string described_as = {};
  double tolerance_ns = 0.0;  ///< What its type can hold.
};
void PrintTo(const Dialect& dialect, std::ostream* out) {
  *out << dialect.name;
}

/// Point i: at (2 + i, -1, 0.5), intensity i % 100, ring or line i % 4, i * 0.5 ms after the stamp.
double value_of(const Dialect& dialect, const std::string& field, int i) {
  if (field == "x") return 2.0 + i;
  if (field == "y") return -1.0;
  if (field == "z") return 0.5;
  const bool has_intensity =
      std::ranges::find(dialect.fields, "intensity", &testing::TestField::name) !=
      dialect.fields.end();
  if (field == "intensity" || (field == "reflectivity" && !has_intensity)) return i % 100;
  if (field == "ring" || field == "line") return i % 4;
  if (field == dialect.time_field) return dialect.first_time + 5e-4 * i * dialect.unit_per_s;
  return field == "tag" ? 0x10 : 7.0;  // what nobody reads
}

std::string message_of(const Dialect& dialect) {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < kPoints; ++i) {
    std::vector<double>& point = points.emplace_back();
    for (const testing::TestField& field : dialect.fields) {
      point.push_back(value_of(dialect, field.name, i));
    }
  }
  return testing::cloud_message(kStamp_ns, dialect.fields, points);
}

class Dialects : public ::testing::TestWithParam<Dialect> {};

TEST_P(Dialects, AreReadWithTheirTimesRingsAndIntensities) {
  const Dialect& dialect = GetParam();
  const std::string message = message_of(dialect);
  ScanDecoder decoder;
  const auto scan = decoder.decode_point_cloud2(std::as_bytes(std::span(message)));
  ASSERT_TRUE(scan) << scan.error().message;
  ASSERT_EQ(scan->points.size(), static_cast<std::size_t>(kPoints));
  EXPECT_EQ(scan->stamp.count(), kStamp_ns);
  for (int i = 0; i < kPoints; ++i) {
    const LidarPoint& point = scan->points[static_cast<std::size_t>(i)];
    EXPECT_EQ(point.point_in_lidar, Eigen::Vector3f(2.0F + static_cast<float>(i), -1.0F, 0.5F));
    const double first_ns = dialect.first_time < 0.0 ? 1e9 * dialect.first_time : 0.0;
    EXPECT_NEAR(point.offset_ns, first_ns + 5e5 * i, dialect.tolerance_ns);
    EXPECT_EQ(point.ring, i % 4);
    EXPECT_EQ(point.intensity, static_cast<float>(i % 100));
  }
  EXPECT_THAT(decoder.point_time(), HasSubstr(dialect.described_as));
  EXPECT_THAT(decoder.take_warnings(), IsEmpty());
}

// Fields in the order and with the types of the drivers' own point types.
INSTANTIATE_TEST_SUITE_P(
    Drivers,
    Dialects,
    ::testing::Values(Dialect{.name = "Velodyne",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"pad", kF32},
                                         {"intensity", kF32},
                                         {"ring", kU16},
                                         {"pad2", kU16},
                                         {"time", kF32}},
                              .time_field = "time",
                              .described_as = "'time' (float32, s, relative",
                              .tolerance_ns = 10.0},
                      Dialect{.name = "Ouster",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"pad", kF32},
                                         {"intensity", kF32},
                                         {"t", kU32},
                                         {"reflectivity", kU16},
                                         {"ring", kU8},
                                         {"pad2", kU8},
                                         {"ambient", kU16},
                                         {"pad3", kU16},
                                         {"range", kU32}},
                              .time_field = "t",
                              .unit_per_s = 1e9,
                              .described_as = "'t' (uint32, ns, relative"},
                      // ouster-ros 0.10 (os_point.h): ring and reflectivity of 16 bits.
                      Dialect{.name = "OusterRing16",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"pad", kF32},
                                         {"intensity", kF32},
                                         {"t", kU32},
                                         {"reflectivity", kU16},
                                         {"ring", kU16},
                                         {"ambient", kU16},
                                         {"pad2", kU16},
                                         {"range", kU32}},
                              .time_field = "t",
                              .unit_per_s = 1e9,
                              .described_as = "'t' (uint32, ns, relative"},
                      // Converters that keep PCL uint64 times.
                      Dialect{.name = "PclUint64Time",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"ring", kU16},
                                         {"timestamp", 10}},
                              .time_field = "timestamp",
                              .first_time = kStamp_s * 1e9,
                              .unit_per_s = 1e9,
                              .described_as = "'timestamp' (uint64, ns, absolute",
                              .tolerance_ns = 256.0},
                      // Drivers whose stamp is that of the last packet.
                      Dialect{.name = "VelodyneBeforeTheStamp",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"ring", kU16},
                                         {"time", kF32}},
                              .time_field = "time",
                              .first_time = -0.1,
                              .described_as = "'time' (float32, s, relative",
                              .tolerance_ns = 10.0},
                      // Times in us, as the option timestamp_unit of FAST-LIO names them.
                      Dialect{.name = "VelodyneMicroseconds",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"time", kF32},
                                         {"ring", kU16}},
                              .time_field = "time",
                              .unit_per_s = 1e6,
                              .described_as = "'time' (float32, us, relative",
                              .tolerance_ns = 10.0},
                      // livox_ros_driver2 1.2.4 (LivoxPointXyzrtlt), Mid-360, HAP: packed 26 bytes.
                      // Without a synchronised clock: nanoseconds since power-on.
                      Dialect{.name = "LivoxPointXyzrtlt",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"reflectivity", kF32},
                                         {"tag", kU8},
                                         {"line", kU8},
                                         {"timestamp", kF64}},
                              .time_field = "timestamp",
                              .first_time = kStamp_s * 1e9,
                              .unit_per_s = 1e9,
                              .described_as = "'timestamp' (float64, ns, absolute",
                              .tolerance_ns = 256.0},
                      Dialect{.name = "Hesai",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"timestamp", kF64},
                                         {"ring", kU16}},
                              .time_field = "timestamp",
                              .first_time = kStamp_s,
                              .described_as = "'timestamp' (float64, s, absolute",
                              .tolerance_ns = 240.0},  // doubles of this size are 238 ns apart
                      Dialect{.name = "RoboSense",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"pad", kF32},
                                         {"intensity", kF32},
                                         {"ring", kU16},
                                         {"pad2", kU16},
                                         {"timestamp", kF64}},
                              .time_field = "timestamp",
                              .first_time = kStamp_s,
                              .described_as = "'timestamp' (float64, s, absolute",
                              .tolerance_ns = 240.0},
                      Dialect{.name = "LivoxDriver",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"tag", kU8},
                                         {"line", kU8},
                                         {"offset_time", kU32}},
                              .time_field = "offset_time",
                              .unit_per_s = 1e9,
                              .described_as = "'offset_time' (uint32, ns, relative"},
                      Dialect{.name = "LivoxDriver2",
                              .fields = {{"x", kF32},
                                         {"y", kF32},
                                         {"z", kF32},
                                         {"intensity", kF32},
                                         {"tag", kU8},
                                         {"line", kU8},
                                         {"timestamp", kF64}},
                              .time_field = "timestamp",
                              .first_time = kStamp_s * 1e9,
                              .unit_per_s = 1e9,
                              .described_as = "'timestamp' (float64, ns, absolute",
                              .tolerance_ns = 256.0}),
    [](const auto& test) { return test.param.name; });

TEST(Dialects, PointsWithoutAReturnAreNaNOrZeroAndKeepTheScan) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double empty : {kNan, 0.0}) {  // rslidar_sdk (dense_points false); Velodyne, Ouster
    std::vector<std::vector<double>> points;
    for (int i = 0; i < kPoints; ++i) {
      const bool none = i % 3 == 0;
      points.push_back({none ? empty : 2.0 + i, none ? empty : -1.0, none ? empty : 0.5, 5e-4 * i});
    }
    const std::string message = testing::cloud_message(
        kStamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}, {"time", kF32}}, points);
    ScanDecoder decoder;
    const auto scan = decoder.decode_point_cloud2(std::as_bytes(std::span(message)));
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->points.size(), static_cast<std::size_t>(kPoints));
    EXPECT_NEAR(scan->points[100].offset_ns, 5e7, 10.0);
    EXPECT_THAT(decoder.take_warnings(), IsEmpty());
  }
}

}  // namespace
}  // namespace hybridfusion
