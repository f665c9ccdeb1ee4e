#include "bag_builder.hpp"
#include "mutations.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::cloud_message;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::TestField;

constexpr std::int64_t kStamp_ns = 1'777'674'600'050'000'000;
constexpr double kStamp_s = 1'777'674'600.05;
constexpr std::uint8_t kU8 = 2;
constexpr std::uint8_t kU16 = 4;
constexpr std::uint8_t kU32 = 6;
constexpr std::uint8_t kF32 = 7;
constexpr std::uint8_t kF64 = 8;

[[nodiscard]] std::span<const std::byte> bytes_of(const std::string& message) {
  return std::as_bytes(std::span(message));
}

/// 100 points with the given time values at 0, 1, ... 99 per cent of a 0.1 s scan.
[[nodiscard]] std::string timed_scan(const std::string& field,
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

struct TimeCase {
  const char* field;
  std::uint8_t datatype;
  double first;
  double unit_per_s;
  const char* unit;
  double tolerance_ns;  ///< What the type can hold.
};
class PointTimes : public ::testing::TestWithParam<TimeCase> {};
INSTANTIATE_TEST_SUITE_P(
    Drivers,
    PointTimes,
    ::testing::Values(TimeCase{"time", kF32, 0.0, 1.0, "float32, s, relative", 5.0},   // Velodyne
                      TimeCase{"time", kF32, 0.0, 1e6, "float32, us, relative", 5.0},  // older
                      TimeCase{"t", kU32, 0.0, 1e9, "uint32, ns, relative", 0.0},      // Ouster
                      TimeCase{"timeOffset", kF32, 0.0, 1e3, "float32, ms, relative", 5.0},
                      TimeCase{"offset_time", kU32, 0.0, 1e9, "uint32, ns, relative", 0.0},
                      // Doubles of this size are 238 ns and 256 ns apart.
                      TimeCase{"timestamp", kF64, kStamp_s, 1.0, "float64, s, absolute", 240.0},
                      TimeCase{
                          "timestamp", kF64, kStamp_s * 1e9, 1e9, "float64, ns, absolute", 256.0}));

TEST_P(PointTimes, AreFoundByNameTypeAndSpan) {
  const TimeCase& param = GetParam();
  for (const bool big_endian : {false, true}) {
    ScanDecoder decoder;
    const auto scan = decoder.decode_point_cloud2(bytes_of(
        timed_scan(param.field, param.datatype, param.first, param.unit_per_s, big_endian)));
    ASSERT_TRUE(scan) << scan.error().message;
    ASSERT_EQ(scan->points.size(), 100U);
    EXPECT_EQ(scan->stamp.count(), kStamp_ns);
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(scan->points[i].point_in_lidar.x(), 1.0F + static_cast<float>(i));
      EXPECT_NEAR(scan->points[i].offset_ns, i * 1e6, param.tolerance_ns);
    }
    EXPECT_THAT(decoder.point_time(), AllOf(HasSubstr(param.field), HasSubstr(param.unit)));
    EXPECT_THAT(decoder.take_warnings(), IsEmpty());
  }
}

TEST(PointTime, OfTheEndOfTheScanIsNegative) {
  ScanDecoder decoder;
  const auto scan = decoder.decode_point_cloud2(bytes_of(timed_scan("time", kF32, -0.1, 1.0)));
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->points.front().offset_ns, -100'000'000, 10);
}

TEST(PointTime, OfAForeignClockIsCountedFromTheFirstPointWithAWarning) {
  ScanDecoder decoder;
  const auto scan =
      decoder.decode_point_cloud2(bytes_of(timed_scan("timestamp", kF64, 312.5, 1.0)));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->points[0].offset_ns, 0);
  EXPECT_NEAR(scan->points[99].offset_ns, 99'000'000, 1);
  EXPECT_THAT(decoder.take_warnings(), ::testing::ElementsAre(HasSubstr("clock")));
}

TEST(PointTime, UnitIsKeptForLaterScansThatDoNotTell) {
  ScanDecoder decoder;
  ASSERT_TRUE(decoder.decode_point_cloud2(bytes_of(timed_scan("time", kF32, 0.0, 1.0))));
  // This one spans 0.099 "ms": read as seconds all the same.
  const auto odd = decoder.decode_point_cloud2(bytes_of(timed_scan("time", kF32, 0.0, 1e-3)));
  ASSERT_TRUE(odd);
  EXPECT_NEAR(odd->points[99].offset_ns, 99'000, 5);
}

/// A whole turn of 0.1 s whose times are `scale` times too long.
[[nodiscard]] std::string scaled_turn(std::int64_t stamp_ns, double scale) {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 360; ++i) {
    const double azimuth = 2.0 * std::numbers::pi * i / 360.0;
    points.push_back(
        {10.0 * std::cos(azimuth), 10.0 * std::sin(azimuth), 1.0, scale * 0.1 * i / 360.0});
  }
  return cloud_message(stamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}, {"time", kF32}}, points);
}

TEST(PointTime, OfNoUnitComesFromTheAzimuth) {
  ScanDecoder decoder;
  for (int i = 0; i < 4; ++i) {
    const auto scan =
        decoder.decode_point_cloud2(bytes_of(scaled_turn(kStamp_ns + i * 100'000'000LL, 1e-3)));
    ASSERT_TRUE(scan);
    EXPECT_NEAR(scan->points[180].offset_ns, 50'000'000, 1'000'000);
  }
  EXPECT_THAT(decoder.take_warnings(),
              ::testing::ElementsAre(AllOf(HasSubstr("point_time_unit"), HasSubstr("azimuth"))));
}

TEST(PointTime, ThatDoesNotFitTheDistanceOfTheScansComesFromTheAzimuth) {
  ScanDecoder decoder;
  LidarScan last;
  for (int i = 0; i < 6; ++i) {
    // 1 s: taken for 1 ms until three scans have told otherwise.
    const auto scan =
        decoder.decode_point_cloud2(bytes_of(scaled_turn(kStamp_ns + i * 100'000'000LL, 10.0)));
    ASSERT_TRUE(scan);
    last = *scan;
  }
  EXPECT_NEAR(last.points[180].offset_ns, 50'000'000, 1'000'000);
  EXPECT_THAT(decoder.point_time(), HasSubstr("azimuth"));
  // A unit that was given is obeyed.
  ScanDecoder told({.unit = "s"});
  for (int i = 0; i < 6; ++i) {
    const auto scan =
        told.decode_point_cloud2(bytes_of(scaled_turn(kStamp_ns + i * 100'000'000LL, 10.0)));
    ASSERT_TRUE(scan);
    last = *scan;
  }
  EXPECT_NEAR(last.points[180].offset_ns, 500'000'000, 100);
}

TEST(PointTime, OverrideOfFieldAndUnitIsObeyed) {
  ScanDecoder decoder({.field = "stamp2", .unit = "us"});
  const auto scan = decoder.decode_point_cloud2(bytes_of(timed_scan("stamp2", kF32, 0.0, 1e6)));
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->points[50].offset_ns, 50'000'000, 8);
  ScanDecoder misspelt({.field = "tine"});
  const auto refused = misspelt.decode_point_cloud2(bytes_of(timed_scan("time", kF32, 0.0, 1.0)));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(refused.error().message, AllOf(HasSubstr("tine"), HasSubstr("time")));
}

TEST(PointTime, AbsoluteEpochInFloat32IsRecognisedAsUseless) {
  ScanDecoder decoder;
  const auto scan = decoder.decode_point_cloud2(bytes_of(timed_scan("time", kF32, kStamp_s, 1.0)));
  ASSERT_TRUE(scan);
  EXPECT_THAT(decoder.take_warnings(), ::testing::ElementsAre(HasSubstr("all the same")));
  EXPECT_EQ(scan->points[50].offset_ns, 50'000'000);  // by order
}

/// One turn of 16 rings, `clockwise` or not, starting at `start_rad`, without times.
[[nodiscard]] std::string untimed_turn(bool clockwise, double start_rad, bool ring_by_ring) {
  std::vector<std::vector<double>> points;
  const auto add = [&](int column, int ring) {
    const double turned = 2.0 * std::numbers::pi * column / 360.0;
    const double azimuth = start_rad + (clockwise ? -turned : turned);
    points.push_back({10.0 * std::cos(azimuth), 10.0 * std::sin(azimuth), 0.2 * ring, ring * 1.0});
  };
  for (int a = 0; a < (ring_by_ring ? 16 : 360); ++a) {
    for (int b = 0; b < (ring_by_ring ? 360 : 16); ++b) ring_by_ring ? add(b, a) : add(a, b);
  }
  return cloud_message(kStamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}, {"ring", kU16}}, points);
}

TEST(PointTime, AbsentTimesOfASpinningLidarComeFromTheAzimuth) {
  for (const bool clockwise : {false, true}) {
    for (const bool ring_by_ring : {false, true}) {
      for (const double start_rad : {-3.1, 0.0, 1.0, 2.9}) {
        ScanDecoder decoder;
        const auto scan =
            decoder.decode_point_cloud2(bytes_of(untimed_turn(clockwise, start_rad, ring_by_ring)));
        ASSERT_TRUE(scan);
        for (std::size_t i = 0; i < scan->points.size(); ++i) {
          const std::size_t column = ring_by_ring ? i % 360 : i / 16;
          // 0.5 ms: the margin of 0.01 rad at the start is 0.16 ms of a 100 ms turn.
          EXPECT_NEAR(scan->points[i].offset_ns, static_cast<double>(column) / 360.0 * 1e8, 5e5);
        }
        EXPECT_THAT(decoder.take_warnings(), ::testing::ElementsAre(HasSubstr("azimuth")));
      }
    }
  }
}

TEST(PointCloud2, IntensityRingAndInvalidReturnsAreKept) {
  const std::vector<TestField> fields = {
      {"intensity", kF32}, {"x", kF64}, {"y", kF64}, {"z", kF64}, {"ring", kU16}};
  ScanDecoder decoder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto scan = decoder.decode_point_cloud2(
      bytes_of(cloud_message(kStamp_ns, fields, {{7.5, 1, 2, 3, 31}, {0, nan, nan, nan, 5}})));
  ASSERT_TRUE(scan) << scan.error().message;
  ASSERT_EQ(scan->points.size(), 2U);
  EXPECT_EQ(scan->points[0].intensity, 7.5F);
  EXPECT_EQ(scan->points[0].point_in_lidar, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(scan->points[0].ring, 31);
  EXPECT_TRUE(std::isnan(scan->points[1].point_in_lidar.x()));
}

TEST(PointCloud2, LivoxNoiseTagsAreLeftOutInBothMessageTypes) {
  std::vector<testing::LivoxPoint> points;
  std::vector<std::vector<double>> rows;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto tag = static_cast<std::uint8_t>(i);
    points.push_back({i * 1'500'000, 5.0F, static_cast<float>(i), 1.0F, 9, tag, 3});
    rows.push_back({5.0, i * 1.0, 1.0, 9.0, tag * 1.0, 3.0, i * 1.5e6});
  }
  ScanDecoder custom_decoder;
  const auto custom =
      custom_decoder.decode_livox(bytes_of(testing::livox_message(kStamp_ns, points)));
  ScanDecoder cloud_decoder;
  const auto cloud =
      cloud_decoder.decode_point_cloud2(bytes_of(cloud_message(kStamp_ns,
                                                               {{"x", kF32},
                                                                {"y", kF32},
                                                                {"z", kF32},
                                                                {"intensity", kF32},
                                                                {"tag", kU8},
                                                                {"line", kU8},
                                                                {"offset_time", kU32}},
                                                               rows)));
  ASSERT_TRUE(custom && cloud);
  ASSERT_EQ(custom->points.size(), 32U);  // tags 0x00 .. 0x1f
  ASSERT_EQ(cloud->points.size(), 32U);
  EXPECT_EQ(custom->stamp, cloud->stamp);
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_EQ(custom->points[i].point_in_lidar, cloud->points[i].point_in_lidar);
    EXPECT_EQ(custom->points[i].offset_ns, cloud->points[i].offset_ns);
    EXPECT_EQ(custom->points[i].intensity, cloud->points[i].intensity);
    EXPECT_EQ(custom->points[i].ring, cloud->points[i].ring);
  }
}

TEST(PointCloud2, LyingSizesAreRefusedBeforeMemoryIsTaken) {
  const std::string good = timed_scan("time", kF32, 0.0, 1.0);
  const std::size_t height_at = testing::ros_header(kStamp_ns).size();
  for (const std::size_t field_at : {height_at, height_at + 4, height_at + 8}) {
    std::string bad = good;
    bad.replace(field_at, 4, "\xff\xff\xff\x7f");
    ScanDecoder decoder;
    const auto scan = decoder.decode_point_cloud2(bytes_of(bad));
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().code, ErrorCode::kParse);
  }
}

TEST(PointCloud2, WithoutCoordinatesIsNotAScan) {
  ScanDecoder decoder;
  const auto scan =
      decoder.decode_point_cloud2(bytes_of(cloud_message(kStamp_ns, {{"range", kF32}}, {{1.0}})));
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(scan.error().message, HasSubstr("range"));
}

TEST(PointCloud2, AnEmptyScanIsAScan) {
  ScanDecoder decoder;
  const auto scan = decoder.decode_point_cloud2(
      bytes_of(cloud_message(kStamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}}, {})));
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->points.empty());
}

TEST(PointCloud2, RandomDamageNeverCrashes) {
  const std::string cloud = timed_scan("time", kF32, 0.0, 1.0);
  const std::string livox = testing::livox_message(
      kStamp_ns, std::vector<testing::LivoxPoint>(50, {1, 2, 3, 4, 5, 6, 7}));
  for (std::uint64_t i = 0; i < 500; ++i) {
    ScanDecoder decoder;
    const std::string bad_cloud = testing::mutated(cloud, i);
    const std::string bad_livox = testing::mutated(livox, i);
    static_cast<void>(decoder.decode_point_cloud2(bytes_of(bad_cloud)));
    static_cast<void>(decoder.decode_livox(bytes_of(bad_livox)));
  }
}

}  // namespace
}  // namespace hybridfusion
