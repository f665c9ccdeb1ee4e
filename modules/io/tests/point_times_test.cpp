#include "cloud_messages.hpp"
#include "test_recording.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::bytes_of;
using testing::cloud_message;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kF32;
using testing::kF64;
using testing::kStamp_ns;
using testing::kStamp_s;
using testing::kU16;
using testing::kU32;
using testing::timed_scan;

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
                      TimeCase{"timestamp", 10, kStamp_s * 1e9, 1e9, "uint64, ns, absolute", 256.0},
                      TimeCase{"timestamp", 9, kStamp_s * 1e9, 1e9, "int64, ns, absolute", 256.0},
                      TimeCase{"timestamp", 10, kStamp_s * 1e6, 1e6, "uint64, us, absolute", 600.0},
                      TimeCase{"t", 10, 0.0, 1e9, "uint64, ns, relative", 0.0},
                      TimeCase{"t", 9, -1e8, 1e9, "int64, ns, relative", 1.0},
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
      const double first_ns = param.first < 0.0 ? param.first : 0.0;
      EXPECT_NEAR(scan->points[i].offset_ns, first_ns + i * 1e6, param.tolerance_ns);
    }
    EXPECT_THAT(decoder.point_time(), AllOf(HasSubstr(param.field), HasSubstr(param.unit)));
    EXPECT_THAT(decoder.take_warnings(), IsEmpty());
  }
}

TEST(PointTime, OfATypeThatIsNotReadIsNamed) {
  ScanDecoder decoder;
  ASSERT_TRUE(decoder.decode_point_cloud2(bytes_of(timed_scan("timestamp", 11, 0.0, 1.0))));
  EXPECT_THAT(
      decoder.take_warnings(),
      ::testing::ElementsAre(
          AllOf(HasSubstr("timestamp (datatype 11"), HasSubstr("not read"), HasSubstr("made up"))));
  EXPECT_TRUE(decoder.made_up());
  ScanDecoder unknown;
  ASSERT_TRUE(unknown.decode_point_cloud2(bytes_of(timed_scan("zeit", kF64, 0.0, 1.0))));
  EXPECT_THAT(unknown.take_warnings(),
              ::testing::ElementsAre(AllOf(HasSubstr("zeit"), HasSubstr("made up"))));
  ScanDecoder timed;
  ASSERT_TRUE(timed.decode_point_cloud2(bytes_of(timed_scan("time", kF32, 0.0, 1.0))));
  EXPECT_FALSE(timed.made_up());
}

TEST(PointTime, OfSecondsAndNanosecondsApartIsJoined) {
  std::vector<std::vector<double>> points;
  const double whole_s = std::floor(kStamp_s);
  for (int i = 0; i < 100; ++i) points.push_back({1.0 + i, 2.0, 3.0, whole_s, 5e7 + i * 1e6});
  ScanDecoder decoder;
  const auto scan = decoder.decode_point_cloud2(bytes_of(
      cloud_message(kStamp_ns,
                    {{"x", kF32}, {"y", kF32}, {"z", kF32}, {"time_sec", 10}, {"time_nsec", kU32}},
                    points)));
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->points[99].offset_ns, 99'000'000, 256);
  EXPECT_THAT(decoder.take_warnings(), IsEmpty());
}

TEST(PointTime, ThatIsAbsoluteCorrectsADisplacedStamp) {
  ScanDecoder decoder;
  const auto at = [&](std::int64_t stamp_ns, double first_s) {
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 100; ++i) points.push_back({1.0 + i, 2.0, 3.0, first_s + i * 0.001});
    return decoder.decode_point_cloud2(bytes_of(cloud_message(
        stamp_ns, {{"x", kF32}, {"y", kF32}, {"z", kF32}, {"timestamp", kF64}}, points)));
  };
  ASSERT_TRUE(at(kStamp_ns, kStamp_s));
  for (const std::int64_t wrong_ns : {std::int64_t{0}, kStamp_ns - 3'000'000'000}) {
    const auto scan = at(wrong_ns, kStamp_s + 0.1);
    ASSERT_TRUE(scan);
    ASSERT_EQ(scan->points.size(), 100U);
    EXPECT_NEAR(static_cast<double>(scan->stamp.count() - kStamp_ns), 1e8, 300.0);
    EXPECT_NEAR(scan->points[50].offset_ns, 50'000'000, 300);
  }
}

TEST(ByteOrder, AFlagThatContradictsTheBytesIsNotObeyed) {
  const std::string right = timed_scan("time", kF32, 0.0, 1.0);
  for (const bool big_endian : {false, true}) {
    std::string message = timed_scan("time", kF32, 0.0, 1.0, big_endian);
    // The flag stands before point_step, row_step, length, 100 points of 16 bytes and is_dense.
    message[message.size() - 1 - 1600 - 13] = static_cast<char>(!big_endian);
    ScanDecoder decoder;
    const auto scan = decoder.decode_point_cloud2(bytes_of(message));
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->points[7].point_in_lidar, Eigen::Vector3f(8.0F, 2.0F, 3.0F));
    EXPECT_NEAR(scan->points[99].offset_ns, 99'000'000, 5);
    EXPECT_THAT(decoder.take_warnings(), ::testing::ElementsAre(HasSubstr("is_bigendian")));
  }
}

/// The message as point_cloud_transport compresses it: the data packed, is_dense, the format.
[[nodiscard]] std::string compressed(const std::string& message,
                                     std::size_t data_bytes,
                                     const std::string& packed,
                                     const std::string& format) {
  std::string out = message.substr(0, message.size() - 1 - data_bytes - 4);
  testing::put_string(out, packed);
  out += '\1';
  testing::put_string(out, format);
  return out;
}

TEST(CompressedCloud, OfZstdGivesTheSamePointsAndOthersAreNamed) {
  const std::string message = timed_scan("time", kF32, 0.0, 1.0);
  const std::string data = message.substr(message.size() - 1 - 1600, 1600);
  const std::string packed = compressed(message, 1600, testing::zstd_packed(data), "zstd");
  ScanDecoder decoder;
  const auto plain = decoder.decode_point_cloud2(bytes_of(message));
  const auto scan = decoder.decode_compressed(bytes_of(packed), RosWire::kRos1);
  ASSERT_TRUE(plain && scan);
  ASSERT_EQ(scan->points.size(), plain->points.size());
  for (std::size_t i = 0; i < scan->points.size(); ++i) {
    EXPECT_EQ(scan->points[i].point_in_lidar, plain->points[i].point_in_lidar);
    EXPECT_EQ(scan->points[i].offset_ns, plain->points[i].offset_ns);
  }
  const auto draco = decoder.decode_compressed(
      bytes_of(compressed(message, 1600, "DRACO....", "draco")), RosWire::kRos1);
  ASSERT_FALSE(draco);
  EXPECT_THAT(draco.error().message, AllOf(HasSubstr("'draco'"), HasSubstr("republish")));
  // Less data than announced, more than announced, cut.
  for (const std::string& bad :
       {testing::zstd_packed(data.substr(100)),
        testing::zstd_packed(data).substr(0, 40),
        testing::zstd_packed(std::string(1 << 20, 'x')) + std::string(3, 'y')}) {
    static_cast<void>(decoder.decode_compressed(bytes_of(compressed(message, 1600, bad, "zstd")),
                                                RosWire::kRos1));
  }
  EXPECT_FALSE(decoder.decode_compressed(
      bytes_of(compressed(message, 1600, testing::zstd_packed(data.substr(100)), "zstd")),
      RosWire::kRos1));
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

}  // namespace
}  // namespace hybridfusion
