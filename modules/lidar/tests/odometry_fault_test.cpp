#include "simulated_drive.hpp"

#include <hybridfusion/lidar/odometry.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::kDriveStart_s;
using testing::messages_of;
using testing::SimulatedDrive;
using testing::standard_drive;

double seconds_in(Timestamp time) {
  return to_seconds(time - from_seconds(kDriveStart_s));
}

/// What drivers, clocks, plugs and people do to a recording.
struct Fault {
  std::string name = {};
  std::function<void(SimulatedDrive&)> break_it = {};
  std::size_t lost_scans = 0;         ///< At most so many may stay without a pose.
  std::uint32_t expected_flag = 0;    ///< Raised on at least one scan.
  std::string expected_warning = {};  ///< Without either the drive must stay accurate.
  double max_error_m = 0.03;          ///< Of a drive that is flagged.
  /// What else the summary must say.
  std::function<bool(const OdometrySummary&)> summary_tells = {};
};

void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}

template <class Change>
auto every_point(Change change) {
  return [change](SimulatedDrive& drive) {
    for (LidarScan& scan : drive.scans) {
      for (LidarPoint& point : scan.points) change(point);
    }
  };
}

template <class Change>
auto every_sample(Change change) {
  return [change](SimulatedDrive& drive) {
    for (ImuSample& sample : drive.imu) change(sample);
  };
}

void keep_every(std::size_t n, SimulatedDrive& drive) {
  std::vector<ImuSample> kept;
  for (std::size_t i = 0; i < drive.imu.size(); i += n) kept.push_back(drive.imu[i]);
  drive.imu = std::move(kept);
}

void turn_the_imu_over(SimulatedDrive& drive) {
  const Eigen::Quaterniond over(0.0, 1.0, 0.0, 0.0);  // half a turn about x
  for (ImuSample& sample : drive.imu) {
    sample.angular_velocity_radps = over * sample.angular_velocity_radps;
    sample.specific_force_mps2 = over * sample.specific_force_mps2;
  }
  drive.rig.imu_from_lidar = Rigid3{.rotation = over} * drive.rig.imu_from_lidar;
}

void forget_the_start(SimulatedDrive& drive) {
  std::erase_if(drive.imu, [](const ImuSample& s) { return seconds_in(s.time) < 5.0; });
  std::erase_if(drive.scans, [](const LidarScan& s) { return seconds_in(s.stamp) < 5.0; });
}

// A scan lasts 0.6 m of way; without point times a quarter of it stays in the worst place.
constexpr double kWithinAScan_m = 0.15;

std::vector<Fault> point_faults() {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  return {{.name = "NanPoints",
           .break_it =
               [](SimulatedDrive& drive) {
                 for (LidarScan& scan : drive.scans) {
                   for (std::size_t i = 0; i < scan.points.size(); i += 3) {
                     scan.points[i].point_in_lidar.x() = kNan;
                   }
                 }
               }},
          {.name = "UnsortedPoints",
           .break_it =
               [](SimulatedDrive& drive) {
                 for (LidarScan& scan : drive.scans) std::ranges::reverse(scan.points);
               }},
          {.name = "ZeroPointTimes",
           .break_it = every_point([](LidarPoint& point) { point.offset_ns = 0; }),
           .expected_flag = bit(ScanFlag::kNoPointTimes),
           .max_error_m = kWithinAScan_m},
          {.name = "PointTimesAThousandTimesTooShort",
           .break_it = every_point([](LidarPoint& point) { point.offset_ns /= 1000; }),
           .expected_flag = bit(ScanFlag::kNoPointTimes),
           .max_error_m = kWithinAScan_m},
          {.name = "PointTimesTenTimesTooLong",
           .break_it = every_point([](LidarPoint& point) { point.offset_ns *= 10; }),
           .expected_flag = bit(ScanFlag::kNoPointTimes),
           .max_error_m = kWithinAScan_m},
          {.name = "RingMajorPoints", .break_it = [](SimulatedDrive& drive) {
             for (LidarScan& scan : drive.scans) {
               std::ranges::stable_sort(scan.points, {}, &LidarPoint::ring);
             }
           }}};
}

std::vector<Fault> imu_faults() {
  return {{.name = "ImuAt100Hz", .break_it = [](SimulatedDrive& drive) { keep_every(2, drive); }},
          // 12.5 Hz: an interval of the IMU holds one sample or none.
          {.name = "OneImuSampleAScan",
           .break_it = [](SimulatedDrive& drive) { keep_every(16, drive); },
           .expected_warning = "samples a second"},
          {.name = "ImuGapOfOneSecond",
           .break_it =
               [](SimulatedDrive& drive) {
                 std::erase_if(drive.imu, [](const ImuSample& s) {
                   return seconds_in(s.time) > 6.0 && seconds_in(s.time) < 7.0;
                 });
               },
           .expected_flag = bit(ScanFlag::kImuGap),
           .summary_tells = [](const OdometrySummary& s) { return s.num_imu_gaps == 1; }},
          {.name = "ImuStampGoesBackOnce",
           .break_it =
               [](SimulatedDrive& drive) {
                 for (std::size_t i = 1300; i < 1304; ++i) {
                   drive.imu[i].time -= std::chrono::seconds(3);
                 }
               }},
          {.name = "ImuInG",
           .break_it = every_sample([](ImuSample& s) { s.specific_force_mps2 /= 9.80665; }),
           .summary_tells = [](const OdometrySummary& s) { return s.imu_in_g; }},
          {.name = "SaturatedImu",
           .break_it =
               [](SimulatedDrive& drive) {
                 for (std::size_t i = 1200; i < 1260; ++i) {
                   drive.imu[i].angular_velocity_radps.z() = 4.36;
                   drive.imu[i].specific_force_mps2.x() = 39.2;
                 }
               },
           .expected_flag = bit(ScanFlag::kSaturated)},
          {.name = "NoStandstill",
           .break_it = forget_the_start,
           .expected_warning = "no standstill",
           .summary_tells = [](const OdometrySummary& s) { return !s.started_at_standstill; }},
          {.name = "UpsideDown", .break_it = turn_the_imu_over}};
}

std::vector<Fault> scan_faults() {
  return {
      {.name = "EmptyScans",
       .break_it =
           [](SimulatedDrive& drive) {
             for (std::size_t i = 30; i < drive.scans.size(); i += 20) {
               drive.scans[i].points.clear();
             }
           },
       .expected_flag = bit(ScanFlag::kFewPoints)},
      {.name = "LidarGapOfTwoSeconds",
       .break_it =
           [](SimulatedDrive& drive) {
             std::erase_if(drive.scans, [](const LidarScan& s) {
               return seconds_in(s.stamp) > 6.0 && seconds_in(s.stamp) < 8.0;
             });
           },
       .expected_flag = bit(ScanFlag::kLidarGap),
       .summary_tells = [](const OdometrySummary& s) { return s.num_lidar_gaps == 1; }},
      {.name = "LidarStampGoesBackOnce",
       .break_it = [](SimulatedDrive& drive) { drive.scans[60].stamp -= std::chrono::seconds(3); },
       .lost_scans = 1,
       .summary_tells = [](const OdometrySummary& s) { return s.num_scans_dropped == 1; }},
      {.name = "DuplicateScans", .break_it = [](SimulatedDrive& drive) {
         for (std::size_t i = 20; i < 80; i += 10) {
           const LidarScan copy = drive.scans[i];
           drive.scans.insert(drive.scans.begin() + static_cast<std::ptrdiff_t>(i), copy);
         }
       }}};
}

std::vector<Fault> faults() {
  std::vector<Fault> all = point_faults();
  for (const auto& more : {imu_faults(), scan_faults()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

struct Outcome {
  Trajectory trajectory = {};
  OdometrySummary summary = {};
  std::uint32_t flags = 0;
  double error_m = 0.0;
};

/// Messages come in the order in which they were taken, whatever the stamps say later.
Outcome run(const std::function<void(SimulatedDrive&)>& break_it) {
  SimulatedDrive drive = standard_drive();
  break_it(drive);
  auto odometry = LidarOdometry::create({}, drive.rig);
  EXPECT_TRUE(odometry);
  std::vector<SensorMessage> messages = messages_of(drive);
  Outcome out;
  for (const SensorMessage& message : messages) {
    if (const auto* imu = std::get_if<ImuSample>(&message)) odometry->add_imu(*imu);
    if (const auto* scan = std::get_if<LidarScan>(&message)) odometry->add_scan(*scan);
  }
  EXPECT_TRUE(odometry->finish());
  for (const ScanEstimate& scan : odometry->take()) {
    EXPECT_TRUE(scan.map_from_imu.translation.allFinite());
    EXPECT_TRUE(scan.covariance.allFinite());
    out.trajectory.poses.push_back({.time = scan.time, .map_from_body = scan.map_from_imu});
    out.flags |= scan.quality.flags;
  }
  out.summary = odometry->summary();
  out.error_m = testing::trajectory_error_m(out.trajectory);
  return out;
}

double clean_error_m() {
  static const double error_m = run([](SimulatedDrive&) {}).error_m;
  return error_m;
}

bool warns_of(const OdometrySummary& summary, const std::string& what) {
  return std::ranges::any_of(summary.warnings, [&](const std::string& warning) {
    return warning.find(what) != std::string::npos;
  });
}

class Faults : public ::testing::TestWithParam<Fault> {};

TEST_P(Faults, AreBridgedOrFlagged) {
  const Fault& fault = GetParam();
  SimulatedDrive broken = standard_drive();
  fault.break_it(broken);
  const Outcome outcome = run(fault.break_it);
  EXPECT_GE(outcome.trajectory.poses.size() + fault.lost_scans + outcome.summary.num_scans_dropped,
            broken.scans.size());
  for (std::size_t i = 1; i < outcome.trajectory.poses.size(); ++i) {
    EXPECT_GT(outcome.trajectory.poses[i].time, outcome.trajectory.poses[i - 1].time);
  }
  if (fault.expected_flag != 0 || !fault.expected_warning.empty()) {
    EXPECT_EQ(outcome.flags & fault.expected_flag, fault.expected_flag)
        << flags_text(outcome.flags);
    EXPECT_TRUE(fault.expected_warning.empty() ||
                warns_of(outcome.summary, fault.expected_warning));
    // Flagged, but not lost either: no bridge may jump.
    EXPECT_LT(outcome.error_m, fault.max_error_m);
  } else {
    // The clean run has a few millimetres; two of them are the noise of a single seed.
    EXPECT_LE(outcome.error_m, 1.5 * clean_error_m() + 0.002);
  }
  if (fault.summary_tells) {
    EXPECT_TRUE(fault.summary_tells(outcome.summary));
  }
}

INSTANTIATE_TEST_SUITE_P(LidarOdometry,
                         Faults,
                         ::testing::ValuesIn(faults()),
                         [](const auto& test) { return test.param.name; });

TEST(RigCheck, SaysNothingOfACleanDrive) {
  EXPECT_FALSE(warns_of(run([](SimulatedDrive&) {}).summary, "--calibrate"));
}

TEST(RigCheck, WarnsOfClocksTwentyMillisecondsApart) {
  for (const int offset_ms : {-20, 20}) {
    const Outcome outcome = run(every_sample(
        [&](ImuSample& sample) { sample.time += std::chrono::milliseconds(offset_ms); }));
    EXPECT_TRUE(warns_of(outcome.summary, "time offset")) << offset_ms;
    EXPECT_TRUE(warns_of(outcome.summary, "--calibrate"));
    EXPECT_LT(outcome.error_m, 0.5);
  }
}

TEST(RigCheck, WarnsOfAWrongMounting) {
  const Outcome outcome = run([](SimulatedDrive& drive) {
    const Eigen::AngleAxisd off(0.1, Eigen::Vector3d(1.0, 0.5, 0.0).normalized());
    drive.rig.imu_from_lidar.rotation = drive.rig.imu_from_lidar.rotation * Eigen::Quaterniond(off);
  });
  EXPECT_TRUE(warns_of(outcome.summary, "imu_from_lidar"));
}

}  // namespace
}  // namespace hybridfusion
