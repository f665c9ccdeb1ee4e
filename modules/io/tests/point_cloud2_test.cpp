#include "cloud_messages.hpp"
#include "mutations.hpp"

#include <hybridfusion/io/point_cloud2.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::bytes_of;
using testing::cloud_message;
using ::testing::HasSubstr;
using testing::kF32;
using testing::kF64;
using testing::kStamp_ns;
using testing::kU16;
using testing::kU32;
using testing::kU8;
using testing::TestField;
using testing::timed_scan;

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
