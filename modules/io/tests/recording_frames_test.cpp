#include "recorded_content.hpp"

namespace hybridfusion {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using testing::Content;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kStart_ns;
using testing::read_all;
using testing::TempFolder;

constexpr std::int64_t kMs = 1'000'000;

std::string scan(std::int64_t stamp_ns, double x, std::string_view frame) {
  std::vector<std::vector<double>> points;
  for (int k = 0; k < 50; ++k) points.push_back({x, 2.0, 3.0, k * 0.002});
  return testing::cloud_message(
      stamp_ns, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, points, false, frame);
}

/// Frames of the i-th message; empty names are left out.
struct Frames {
  std::function<std::vector<std::string>(int)> imu = [](int) {
    return std::vector<std::string>{"imu"};
  };
  std::function<std::vector<std::string>(int)> lidar = [](int) {
    return std::vector<std::string>{"lidar"};
  };
};

/// Two seconds; what a sensor measures tells which of them it is.
std::string bag_of(const Frames& frames) {
  testing::BagBuilder bag;
  const auto points = bag.add_topic("/points", "sensor_msgs/PointCloud2");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  for (int i = 0; i < 200; ++i) {
    const std::int64_t t = kStart_ns + i * 10 * kMs;
    std::int64_t later = 0;
    for (const std::string& frame : frames.imu(i)) {
      const std::int64_t at = t + later++ * 2 * kMs;
      bag.add_message(imu, at, testing::imu_message(at, frame == "imu" ? 0.5 : 0.25, 9.81, frame));
    }
    later = 0;
    for (const std::string& frame : i % 10 == 0 ? frames.lidar(i / 10) : Frames{}.lidar(0)) {
      if (i % 10 != 0) break;
      const std::int64_t at = t + later++ * kMs;
      bag.add_message(points, at, scan(at, frame == "lidar" ? 7.0 : -7.0, frame));
    }
    if (i % 50 == 49) bag.end_chunk();
  }
  return bag.finish();
}

std::vector<std::string> both(const char* one, const char* other) {
  return {one, other};
}

/// The error of reading to the end; empty without one.
std::string refusal(const std::filesystem::path& path,
                    const RecordingOptions& options,
                    RecordingSummary* summary = nullptr) {
  auto source = open_recording(path, options);
  if (!source) return source.error().message;
  for (;;) {
    const auto message = (*source)->next();
    if (summary != nullptr) *summary = (*source)->summary();
    if (!message) {
      EXPECT_EQ(message.error().code, ErrorCode::kNotFound);
      return message.error().message;
    }
    if (!*message) return {};
  }
}

TEST(RecordingFrames, TwoImusOnOneTopicAreRefusedUntilOneIsChosen) {
  const TempFolder folder;
  const auto path =
      folder.file("a.bag", bag_of({.imu = [](int) { return both("imu", "livox_frame_2"); }}));
  RecordingSummary summary;
  EXPECT_THAT(refusal(path, {}, &summary),
              AllOf(HasSubstr("'imu' (200 messages)"),
                    HasSubstr("'livox_frame_2' (200 messages)"),
                    HasSubstr("lidar.recording.imu_frame"),
                    HasSubstr("several IMU")));
  EXPECT_TRUE(summary.undecided_frames);
  for (const auto& [frame, gyro] :
       {std::pair("imu", " 0.5 "), std::pair("livox_frame_2", " 0.25 ")}) {
    const Content content = read_all(path, {.imu_frame = frame});
    EXPECT_EQ(content.summary.num_imu_samples, 200U);
    EXPECT_EQ(content.summary.num_scans, 20U);
    EXPECT_THAT(content.imu, HasSubstr(gyro));
    EXPECT_EQ(content.summary.warnings.size(), 0U);
  }
  EXPECT_THAT(refusal(path, {.imu_frame = "imu_3"}),
              AllOf(HasSubstr("'imu_3'"), HasSubstr("'livox_frame_2'"), HasSubstr("imu_frame")));
}

TEST(RecordingFrames, TwoLidarsOnOneTopicAreRefusedUntilOneIsChosen) {
  const TempFolder folder;
  const auto path =
      folder.file("a.bag", bag_of({.lidar = [](int) { return both("lidar", "rear"); }}));
  EXPECT_THAT(refusal(path, {}),
              AllOf(HasSubstr("'rear' (20 messages)"), HasSubstr("lidar_frame")));
  // As tf wrote it.
  const Content content = read_all(path, {.lidar_frame = "/rear"});
  EXPECT_EQ(content.summary.num_scans, 20U);
  EXPECT_THAT(content.scans, HasSubstr("-7 2 3"));
}

TEST(RecordingFrames, ASensorThatSpeaksSeldomOrJoinsLateIsFound) {
  const TempFolder folder;
  const auto late =
      folder.file("a.bag", bag_of({.imu = [](int i) {
                    return i < 150 ? std::vector<std::string>{"imu"} : both("imu", "late");
                  }}));
  EXPECT_THAT(refusal(late, {}), HasSubstr("'late' (50 messages)"));
  const auto seldom =
      folder.file("b.bag", bag_of({.imu = [](int i) {
                    return i % 60 != 30 ? std::vector<std::string>{"imu"} : both("imu", "seldom");
                  }}));
  EXPECT_THAT(refusal(seldom, {}), HasSubstr("'seldom' (3 messages)"));
}

TEST(RecordingFrames, ADriverRestartedUnderAnotherNameIsOneSensor) {
  const TempFolder folder;
  const auto path = folder.file(
      "a.bag",
      bag_of({.imu = [](int i) { return std::vector<std::string>{i < 90 ? "imu" : "imu_link"}; },
              .lidar = [](int i) { return std::vector<std::string>{i < 9 ? "lidar" : "velo"}; }}));
  const Content content = read_all(path);
  EXPECT_EQ(content.summary.num_imu_samples, 200U);
  EXPECT_EQ(content.summary.num_scans, 20U);
  EXPECT_THAT(content.summary.warnings,
              Contains(AllOf(HasSubstr("'velo'"), HasSubstr("restarted"))));
  // A slash in front is no other name.
  const auto slash = folder.file(
      "b.bag",
      bag_of({.imu = [](int i) { return std::vector<std::string>{i % 2 == 0 ? "imu" : "/imu"}; }}));
  EXPECT_THAT(read_all(slash).summary.warnings, IsEmpty());
}

TEST(RecordingFrames, LivoxUnitsOfOneFrameAreToldApartByTheirNumber) {
  const TempFolder folder;
  testing::BagBuilder bag;
  const auto points = bag.add_topic("/livox/lidar", "livox_ros_driver/CustomMsg");
  const auto imu = bag.add_topic("/imu", "sensor_msgs/Imu");
  for (int i = 0; i < 20; ++i) {
    const std::int64_t t = kStart_ns + i * 100 * kMs;
    bag.add_message(imu, t, testing::imu_message(t, 0.0, 9.81));
    for (std::uint8_t unit = 1; unit <= 2; ++unit) {
      std::vector<testing::LivoxPoint> cloud(50, {0, 1.0F * unit, 2.0F, 3.0F, 9, 0, 0});
      for (std::uint32_t k = 0; k < cloud.size(); ++k) cloud[k].offset_ns = 2'000'000 * k;
      bag.add_message(points, t + unit, testing::livox_message(t + unit, cloud, unit));
    }
  }
  const auto path = folder.file("a.bag", bag.finish());
  EXPECT_THAT(refusal(path, {}), AllOf(HasSubstr("'frame#1'"), HasSubstr("'frame#2'")));
  EXPECT_EQ(read_all(path, {.lidar_frame = "frame#2"}).summary.num_scans, 20U);
}

}  // namespace
}  // namespace hybridfusion
