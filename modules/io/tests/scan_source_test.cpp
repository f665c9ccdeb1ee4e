#include "bag_builder.hpp"
#include "mutations.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/scan_source.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using testing::BagBuilder;
using ::testing::HasSubstr;
using testing::TempFolder;

constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

struct Recording {
  std::vector<LidarScan> scans;
  std::vector<ImuSample> imu;
  std::vector<GnssFix> fixes;
  RecordingSummary summary;
};

Recording read_all(ScanSource& source) {
  Recording recording;
  for (;;) {
    auto message = source.next();
    EXPECT_TRUE(message) << message.error().message;
    if (!message || !*message) break;
    if (auto* scan = std::get_if<LidarScan>(&**message))
      recording.scans.push_back(std::move(*scan));
    if (auto* sample = std::get_if<ImuSample>(&**message)) recording.imu.push_back(*sample);
    if (auto* fix = std::get_if<GnssFix>(&**message)) recording.fixes.push_back(*fix);
  }
  recording.summary = source.summary();
  return recording;
}

std::string lidar_message(std::int64_t stamp_ns) {
  std::vector<std::vector<double>> points;
  for (int i = 0; i < 50; ++i) points.push_back({1.0 + i, 2.0, 3.0, i * 0.002});
  return testing::cloud_message(stamp_ns, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, points);
}

/// 20 scans, 200 IMU samples, 10 GNSS fixes in two seconds.
std::string street_bag(BagBuilder::Index index = BagBuilder::Index::kWritten,
                       std::int64_t stamp_shift_ns = 0) {
  BagBuilder bag("lz4");
  const auto lidar = bag.add_topic("/points", "sensor_msgs/PointCloud2");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  const auto gnss = bag.add_topic("/fix", "sensor_msgs/NavSatFix");
  for (int i = 0; i < 200; ++i) {
    const std::int64_t time_ns = kStart_ns + i * 10'000'000LL;
    const std::int64_t stamp_ns = time_ns + stamp_shift_ns;
    bag.add_message(imu, time_ns, testing::imu_message(stamp_ns, 0.1, 9.81));
    if (i % 10 == 0) bag.add_message(lidar, time_ns, lidar_message(stamp_ns));
    if (i % 20 == 0) {
      bag.add_message(gnss, time_ns, testing::fix_message(stamp_ns, 48.0, i == 0 ? -1 : 0, 2.25));
    }
    if (i % 50 == 49) bag.end_chunk();
  }
  return bag.finish(index);
}

TEST(OpenRecording, DetectsTopicsByTypeAndDecodesEveryMessage) {
  const TempFolder folder;
  for (const auto index : {BagBuilder::Index::kWritten, BagBuilder::Index::kMissing}) {
    auto source = open_recording(folder.file("street.bag", street_bag(index)));
    ASSERT_TRUE(source) << source.error().message;
    const Recording recording = read_all(**source);
    ASSERT_EQ(recording.scans.size(), 20U);
    ASSERT_EQ(recording.imu.size(), 200U);
    ASSERT_EQ(recording.fixes.size(), 9U);  // the first has no fix
    EXPECT_EQ(recording.scans[1].stamp.count(), kStart_ns + 100'000'000);
    EXPECT_NEAR(recording.scans[1].points[25].offset_ns, 50'000'000, 5);  // a float of 0.05 s
    EXPECT_EQ(recording.imu[0].specific_force_mps2, Eigen::Vector3d(0, 0, 9.81));
    EXPECT_EQ(recording.imu[0].angular_velocity_radps, Eigen::Vector3d(0.1, 0, 0));
    EXPECT_EQ(recording.fixes[0].sigma_enu_m, Eigen::Vector3d(1.5, 1.5, 1.5));
    EXPECT_EQ(recording.fixes[0].position.latitude_deg, 48.0);
    EXPECT_EQ(recording.summary.lidar_topic, "/points");
    EXPECT_EQ(recording.summary.imu_topic, "/imu");
    EXPECT_EQ(recording.summary.gnss_topic, "/fix");
    EXPECT_EQ(recording.summary.num_scans, 20U);
    EXPECT_THAT(recording.summary.point_time, HasSubstr("'time'"));
    EXPECT_FALSE(recording.summary.truncated);
  }
}

TEST(OpenRecording, TruncatedBagGivesItsStartAndSaysSo) {
  const TempFolder folder;
  const std::string good = street_bag();
  auto source = open_recording(folder.file("cut.bag", good.substr(0, good.size() * 8 / 10)));
  ASSERT_TRUE(source) << source.error().message;
  const Recording recording = read_all(**source);
  EXPECT_GT(recording.imu.size(), 90U);
  EXPECT_LT(recording.imu.size(), 190U);
  EXPECT_TRUE(recording.summary.truncated);
}

TEST(OpenRecording, MissingLidarNamesFileTopicsAndNextStep) {
  BagBuilder bag;
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  static_cast<void>(bag.add_topic("/points", "sensor_msgs/PointCloud2"));  // announced, never sent
  bag.add_message(imu, kStart_ns, "");
  const TempFolder folder;
  const auto source = open_recording(folder.file("nolidar.bag", bag.finish()));
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(source.error().message,
              AllOf(HasSubstr("nolidar.bag"),
                    HasSubstr("no LiDAR topic"),
                    HasSubstr("/imu (sensor_msgs/Imu, 1 messages)"),
                    HasSubstr("/points (sensor_msgs/PointCloud2, 0 messages)"),
                    HasSubstr("record")));
}

TEST(OpenRecording, GivesTheScansOfARecordingWithoutAnImu) {
  BagBuilder bag;
  const auto lidar = bag.add_topic("/points", "sensor_msgs/PointCloud2");
  static_cast<void>(bag.add_topic("/imu", "sensor_msgs/Imu"));  // announced, never sent
  bag.add_message(lidar, kStart_ns, lidar_message(kStart_ns));
  const TempFolder folder;
  auto source = open_recording(folder.file("noimu.bag", bag.finish()));
  ASSERT_TRUE(source) << source.error().message;
  EXPECT_EQ((*source)->summary().imu_topic, "");
  const auto message = (*source)->next();
  ASSERT_TRUE(message && *message);
  EXPECT_TRUE(std::holds_alternative<LidarScan>(**message));
  const auto summary = inspect_recording(folder.path() / "noimu.bag");
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->lidar_topic, "/points");
  EXPECT_EQ(summary->imu_topic, "");
}

TEST(OpenRecording, AskedForTopicMustExistAndFit) {
  const TempFolder folder;
  const auto path = folder.file("street.bag", street_bag());
  const auto misspelt = open_recording(path, {.lidar_topic = "/point"});
  ASSERT_FALSE(misspelt);
  EXPECT_EQ(misspelt.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(misspelt.error().message, AllOf(HasSubstr("'/point'"), HasSubstr("/points")));
  const auto wrong = open_recording(path, {.imu_topic = "/fix"});
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("has type sensor_msgs/NavSatFix"));
  auto without_gnss = open_recording(path, {.gnss_topic = "none"});
  ASSERT_TRUE(without_gnss);
  EXPECT_TRUE(read_all(**without_gnss).fixes.empty());
  const auto bad_unit = open_recording(path, {.point_time_unit = "minutes"});
  ASSERT_FALSE(bad_unit);
  EXPECT_EQ(bad_unit.error().code, ErrorCode::kInvalidOptions);
}

TEST(OpenRecording, OfSeveralLidarTopicsTheFullestIsUsedWithAWarning) {
  BagBuilder bag;
  const auto few = bag.add_topic("/a", "sensor_msgs/PointCloud2");
  const auto many = bag.add_topic("/b", "sensor_msgs/PointCloud2");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  bag.add_message(imu, kStart_ns, testing::imu_message(kStart_ns, 0, 9.81));
  for (const auto topic : {few, many, many}) {
    bag.add_message(topic, kStart_ns, lidar_message(kStart_ns));
  }
  const TempFolder folder;
  const auto source = open_recording(folder.file("a.bag", bag.finish()));
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->summary().lidar_topic, "/b");
  EXPECT_THAT((*source)->summary().warnings,
              ::testing::Contains(HasSubstr("several LiDAR topics")));
}

TEST(OpenRecording, MessagesWithoutStampGetTheTimeOfTheirRecording) {
  const TempFolder folder;
  BagBuilder bag;
  const auto lidar = bag.add_topic("/points", "sensor_msgs/PointCloud2");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  bag.add_message(imu, kStart_ns, testing::imu_message(0, 0, 9.81));
  bag.add_message(lidar, kStart_ns + 5, lidar_message(0));
  auto source = open_recording(folder.file("a.bag", bag.finish()));
  ASSERT_TRUE(source);
  const Recording recording = read_all(**source);
  EXPECT_EQ(recording.imu.at(0).time.count(), kStart_ns);
  EXPECT_EQ(recording.scans.at(0).stamp.count(), kStart_ns + 5);
  EXPECT_THAT(recording.summary.warnings, ::testing::Contains(HasSubstr("without a stamp")));
}

TEST(OpenRecording, RandomDamageNeverCrashes) {
  const TempFolder folder;
  const std::string good = street_bag();
  for (std::uint64_t i = 0; i < 200; ++i) {
    auto source = open_recording(folder.file("bad.bag", testing::mutated(good, i)));
    if (!source) continue;
    for (auto message = (*source)->next(); message && *message; message = (*source)->next()) {
    }
  }
}

TEST(OpenRecording, StreetRecordingHasItsScansAndImuSamples) {
  const auto path = testing::test_data("block-11/street.bag");
  if (!path) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  auto source = open_recording(*path);
  ASSERT_TRUE(source) << source.error().message;
  const Recording recording = read_all(**source);
  EXPECT_EQ(recording.scans.size(), 498U);
  EXPECT_NEAR(static_cast<double>(recording.imu.size()), 10'000.0, 50.0);  // 50.1 s at 200 Hz
  EXPECT_NEAR(static_cast<double>(recording.fixes.size()), 250.0, 5.0);    // at 5 Hz
  EXPECT_THAT(recording.summary.point_time, HasSubstr("'time' (float32, s, relative"));
  EXPECT_TRUE(recording.summary.warnings.empty()) << recording.summary.warnings.front();
  for (std::size_t i = 1; i < recording.scans.size(); ++i) {
    EXPECT_NEAR(to_seconds(recording.scans[i].stamp - recording.scans[i - 1].stamp), 0.1, 0.01);
  }
  EXPECT_EQ(recording.fixes[0].sigma_enu_m, Eigen::Vector3d(1.5, 1.5, 1.5));
}

TEST(OpenRecording, LivoxMessagesAndCloudsOfOneRecordingHoldTheSamePoints) {
  const auto path = testing::test_data("block-12-avia/street.bag");
  if (!path) GTEST_SKIP() << "set HYBRIDFUSION_TEST_DATA to the folder of the test data";
  auto livox_source = open_recording(*path, {.lidar_topic = "/livox/lidar"});
  auto cloud_source = open_recording(*path, {.lidar_topic = "/livox/points"});
  ASSERT_TRUE(livox_source && cloud_source);
  const Recording livox = read_all(**livox_source);
  const Recording cloud = read_all(**cloud_source);
  ASSERT_EQ(livox.scans.size(), 405U);
  ASSERT_EQ(cloud.scans.size(), 405U);
  for (std::size_t i = 0; i < livox.scans.size(); ++i) {
    ASSERT_EQ(livox.scans[i].stamp, cloud.scans[i].stamp);
    ASSERT_EQ(livox.scans[i].points.size(), cloud.scans[i].points.size());
    for (std::size_t k = 0; k < livox.scans[i].points.size(); ++k) {
      const LidarPoint& a = livox.scans[i].points[k];
      const LidarPoint& b = cloud.scans[i].points[k];
      ASSERT_EQ(a.point_in_lidar, b.point_in_lidar);
      ASSERT_EQ(a.offset_ns, b.offset_ns);
      ASSERT_EQ(a.ring, b.ring);
    }
  }
}

}  // namespace
}  // namespace hybridfusion
