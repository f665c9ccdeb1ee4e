#pragma once

/// @file
/// A second of street in a recording, and what a reader makes of it.

#include "container_builders.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/scan_source.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion::testing {

inline constexpr std::int64_t kStart_ns = 1'700'000'000'000'000'000;

/// 10 scans, 100 IMU samples, 5 fixes in one second.
inline TestRecording street() {
  TestRecording recording;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t t = kStart_ns + i * 10'000'000LL;
    const double gyro_x = 0.01 * i;
    recording.messages.push_back({1, t, imu_message(t, gyro_x, 9.81), imu_cdr(t, gyro_x, 9.81)});
    if (i % 10 == 0) {
      std::vector<std::vector<double>> points;
      for (int k = 0; k < 50; ++k) points.push_back({1.0 + k + i, 2.0, 3.0, k * 0.002});
      recording.messages.push_back(
          {0,
           t,
           cloud_message(t, {{"x", 7}, {"y", 7}, {"z", 7}, {"time", 7}}, points),
           cloud_cdr(t, points)});
    }
    if (i % 20 == 0) {
      recording.messages.push_back(
          {2, t, fix_message(t, 48.0 + 1e-6 * i, 0, 2.25), fix_cdr(t, 48.0 + 1e-6 * i, 2.25)});
    }
  }
  return recording;
}

/// Everything a recording delivers, as text that is equal exactly when the values are.
struct Content {
  std::string scans = {};
  std::string imu = {};
  std::string fixes = {};
  RecordingSummary summary = {};
};

inline void append(Content& content, const SensorMessage& message) {
  if (const auto* scan = std::get_if<LidarScan>(&message)) {
    content.scans += fmt::format("scan {}\n", scan->stamp.count());
    for (const LidarPoint& point : scan->points) {
      content.scans += fmt::format("{} {} {} {}\n",
                                   point.point_in_lidar.x(),
                                   point.point_in_lidar.y(),
                                   point.point_in_lidar.z(),
                                   point.offset_ns);
    }
  } else if (const auto* sample = std::get_if<ImuSample>(&message)) {
    content.imu += fmt::format("{} {} {}\n",
                               sample->time.count(),
                               sample->angular_velocity_radps.x(),
                               sample->specific_force_mps2.z());
  } else if (const auto* fix = std::get_if<GnssFix>(&message)) {
    content.fixes += fmt::format("{} {} {} {} {}\n",
                                 fix->time.count(),
                                 fix->position.latitude_deg,
                                 fix->position.longitude_deg,
                                 fix->position.altitude_m,
                                 fix->sigma_enu_m.z());
  }
}

inline Content read_all(const std::filesystem::path& path, const RecordingOptions& options = {}) {
  Content content;
  auto source = open_recording(path, options);
  EXPECT_TRUE(source) << source.error().message;
  if (!source) return content;
  for (;;) {
    auto message = (*source)->next();
    EXPECT_TRUE(message) << message.error().message;
    if (!message || !*message) break;
    append(content, **message);
  }
  content.summary = (*source)->summary();
  return content;
}

inline Content reference(const TempFolder& folder) {
  const Content content = read_all(folder.file("reference.bag", rosbag1_of(street())));
  EXPECT_EQ(content.summary.num_scans, 10U);
  EXPECT_EQ(content.summary.num_imu_samples, 100U);
  EXPECT_EQ(content.summary.num_gnss_fixes, 5U);
  return content;
}

inline void expect_same(const Content& expected, const std::filesystem::path& path) {
  SCOPED_TRACE(path.string());
  const Content content = read_all(path);
  EXPECT_EQ(content.scans, expected.scans);
  EXPECT_EQ(content.imu, expected.imu);
  EXPECT_EQ(content.fixes, expected.fixes);
  EXPECT_EQ(content.summary.num_damaged_messages, 0U);
  EXPECT_FALSE(content.summary.truncated);
  EXPECT_EQ(content.summary.lidar_topic, "/points");
}

}  // namespace hybridfusion::testing
