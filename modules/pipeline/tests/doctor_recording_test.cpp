#include "doctor_inputs.hpp"
#include "recording_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DoctorRecording : public DoctorTest {
 protected:
  [[nodiscard]] std::vector<std::string> findings_of(
      const DriveSpec& drive, const std::string& sensors = kGoodSensors) const {
    write_drive(drive, sensors);
    return ids_of(report_of({.bag = bag()}));
  }
};

TEST_F(DoctorRecording, AHealthyDriveHasNoFindings) {
  EXPECT_THAT(findings_of({}), IsEmpty());
}

TEST_F(DoctorRecording, WhatIsNoBagIsUnreadable) {
  (void)folder_.file("sensors.yaml", kGoodSensors);
  EXPECT_THAT(ids_of(report_of({.bag = bag()})), ElementsAre("recording.unreadable"));
  (void)folder_.file("street.bag", "");
  EXPECT_THAT(ids_of(report_of({.bag = bag()})), ElementsAre("recording.unreadable"));
  (void)folder_.file("street.bag", "#ROSBAG V1.2\n");
  EXPECT_THAT(ids_of(report_of({.bag = bag()})), ElementsAre("recording.unreadable"));
}

TEST_F(DoctorRecording, ATruncatedBagIsAWarning) {
  write_drive();
  std::filesystem::resize_file(bag(), std::filesystem::file_size(bag()) - 40);
  const DoctorReport report = report_of({.bag = bag()});
  EXPECT_THAT(ids_of(report), Contains("recording.truncated"));
}

TEST_F(DoctorRecording, MessagesThatMakeNoSenseAreAWarning) {
  const DriveSpec drive{.cut = [](const std::string& topic, double time_s) {
    return topic == "/imu" && time_s == 4.0;
  }};
  EXPECT_THAT(findings_of(drive), ElementsAre("recording.damaged"));
}

TEST_F(DoctorRecording, MissingTopicsAreTold) {
  EXPECT_THAT(findings_of({.lidar = false}, "imu_topic: /imu\n"), Contains("recording.no_lidar"));
  EXPECT_THAT(findings_of({.imu = false}, "lidar_topic: /points\n"), Contains("recording.no_imu"));
  EXPECT_THAT(findings_of({.gnss = false}, "imu_topic: /imu\n"), Contains("recording.no_gnss"));
}

TEST_F(DoctorRecording, ATopicThatDoesNotExistIsToldWithThoseThatDo) {
  write_drive();
  options_.lidar.recording.lidar_topic = "/velodyne";
  DoctorReport report = report_of({.bag = bag()});
  ASSERT_THAT(ids_of(report), ElementsAre("recording.wrong_topic"));
  EXPECT_THAT(report.findings[0].cause, HasSubstr("/points"));
  options_.lidar.recording.lidar_topic = "/imu";  // of another type
  report = report_of({.bag = bag()});
  EXPECT_THAT(ids_of(report), ElementsAre("recording.wrong_topic"));
}

TEST_F(DoctorRecording, SeveralImusOnOneTopicAreToldWithTheirFrames) {
  const DriveSpec drive{.imu_frames = {"imu", "imu_rear"}};
  write_drive(drive);
  DoctorReport report = report_of({.bag = bag()});
  ASSERT_THAT(ids_of(report), ElementsAre("recording.several_sensors"));
  EXPECT_THAT(report.findings[0].cause, HasSubstr("'imu_rear' (800 messages)"));
  options_.lidar.recording.imu_frame = "imu";
  EXPECT_THAT(ids_of(report_of({.bag = bag()})), IsEmpty());
  options_.lidar.recording.imu_frame = "imu_front";
  EXPECT_THAT(ids_of(report_of({.bag = bag()})), Contains("recording.wrong_topic"));
}

TEST_F(DoctorRecording, PointsWithoutTimeAreAWarning) {
  EXPECT_THAT(findings_of({.point_time = false}), ElementsAre("recording.no_point_time"));
}

TEST_F(DoctorRecording, TheUnitsOfTheImuAreChecked) {
  EXPECT_THAT(findings_of({.accel_z = 1.0}), ElementsAre("recording.imu_in_g"));
  EXPECT_THAT(findings_of({.accel_z = 0.05}), ElementsAre("recording.no_gravity"));
  EXPECT_THAT(findings_of({.accel_z = 9810.0}), ElementsAre("recording.no_gravity"));
  EXPECT_THAT(findings_of({.gyro_x = 12.0}), ElementsAre("recording.gyro_units"));
}

TEST_F(DoctorRecording, ASlowImuIsAWarningAndATooSlowOneAnError) {
  EXPECT_THAT(findings_of({.imu_rate_hz = 50.0}), ElementsAre("recording.imu_rate"));
  EXPECT_THAT(findings_of({.imu_rate_hz = 10.0}), ElementsAre("recording.imu_too_slow"));
}

TEST_F(DoctorRecording, ClocksOfTwoEpochsAreAnError) {
  EXPECT_THAT(findings_of({.imu_shift_s = 37.0}), ElementsAre("recording.clocks"));
  EXPECT_THAT(findings_of({.imu_shift_s = -5e8}), ElementsAre("recording.clocks"));
}

TEST_F(DoctorRecording, GapsAreCountedPerSensor) {
  const auto without = [](const std::string& topic, double begin_s, double end_s) {
    return DriveSpec{.keep = [=](const std::string& name, double time_s) {
      return name != topic || time_s < begin_s || time_s >= end_s;
    }};
  };
  EXPECT_THAT(findings_of(without("/imu", 3.0, 3.3)), ElementsAre("recording.imu_gaps"));
  EXPECT_THAT(findings_of(without("/points", 3.0, 4.0)), ElementsAre("recording.lidar_gaps"));
}

TEST_F(DoctorRecording, StampsThatGoBackAreCounted) {
  DriveSpec drive;
  drive.late = [](const std::string& topic, double time_s) {
    return topic == "/imu" && time_s == 4.0 ? -0.5 : 0.0;
  };
  write_drive(drive);
  const DoctorReport report = report_of({.bag = bag()});
  ASSERT_THAT(ids_of(report), ElementsAre("recording.stamps_back"));
  EXPECT_THAT(report.findings[0].cause, HasSubstr("1 IMU samples and 0 scans"));
}

TEST_F(DoctorRecording, StampsThatRepeatLackOrStepAreTold) {
  const auto imu_at = [](double begin_s, double end_s, auto late_s) {
    return DriveSpec{.late = [=](const std::string& topic, double time_s) {
      return topic == "/imu" && time_s >= begin_s && time_s < end_s ? late_s(time_s) : 0.0;
    }};
  };
  EXPECT_THAT(findings_of(imu_at(4.0, 4.001, [](double) { return -0.005; })),
              ElementsAre("recording.stamps_repeat"));
  EXPECT_THAT(findings_of(imu_at(4.0, 4.001, [](double time_s) { return -1e9 - time_s; })),
              ElementsAre("recording.no_stamps"));
  EXPECT_THAT(findings_of(imu_at(4.0, 9.0, [](double) { return -3.0; })),
              ElementsAre("recording.clock_set"));
}

TEST_F(DoctorRecording, AShortOneIsAWarning) {
  const DriveSpec drive{.keep = [](const std::string&, double time_s) { return time_s < 4.0; }};
  EXPECT_THAT(findings_of(drive), ElementsAre("recording.short"));
}

TEST_F(DoctorRecording, ScansOfFewPointsOrInMillimetresAreTold) {
  EXPECT_THAT(findings_of({.points = 50}), ElementsAre("recording.few_returns"));
  EXPECT_THAT(findings_of({.unit_per_m = 1000.0}), ElementsAre("recording.lidar_units"));
}

TEST_F(DoctorRecording, AGnssWithoutFixOrMotionIsAWarning) {
  EXPECT_THAT(findings_of({.fix_status = -1}), ElementsAre("recording.no_fix"));
  EXPECT_THAT(findings_of({.speed_mps = 0.0}), ElementsAre("recording.no_motion"));
}

TEST_F(DoctorRecording, TopicsWithoutMessagesAreTold) {
  const auto without = [](const std::string& silent) {
    return DriveSpec{.keep = [silent](const std::string& topic, double time_s) {
      return topic != silent || time_s < 0.0;
    }};
  };
  EXPECT_THAT(findings_of(without("/imu")), ElementsAre("recording.no_imu"));
  EXPECT_THAT(findings_of(without("/points")), ElementsAre("recording.no_scans"));
}

TEST_F(DoctorRecording, TheSensorFileIsChecked) {
  EXPECT_THAT(findings_of({}, ""), ElementsAre("sensors.no_extrinsic"));
  EXPECT_THAT(findings_of({}, "imu_topic: /imu\n"), ElementsAre("sensors.no_extrinsic"));
  EXPECT_THAT(findings_of({}, "imu_topik: /imu\n"), ElementsAre("sensors.unreadable"));
  EXPECT_THAT(findings_of({}, "imu_from_lidar: [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"),
              ElementsAre("sensors.extrinsic"));
  EXPECT_THAT(
      findings_of({}, "imu_from_lidar: [1, 0, 0, 85, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"),
      ElementsAre("sensors.far"));
}

TEST(StampStatistics, CountsGapsAndStepsBack) {
  StampStatistics stamps;
  for (const double time_s : {0.0, 0.1, 0.2, 0.15, 0.3, 1.3, 1.4}) stamps.add(from_seconds(time_s));
  EXPECT_EQ(stamps.count(), 7U);
  EXPECT_EQ(stamps.backwards(), 1U);
  EXPECT_NEAR(stamps.period_s(), 0.1, 1e-6);
  EXPECT_EQ(stamps.gaps(0.5).count, 1U);
  EXPECT_NEAR(stamps.gaps(0.5).longest_s, 1.0, 1e-6);
  EXPECT_NEAR(stamps.duration_s(), 1.4, 1e-9);
}

TEST(Quantile, IgnoresWhatIsNotFiniteAndIsZeroForNothing) {
  EXPECT_EQ(quantile_of({}, 0.5), 0.0);
  EXPECT_EQ(quantile_of({std::nan("")}, 0.5), 0.0);
  EXPECT_EQ(quantile_of({3.0, 1.0, 2.0, std::nan("")}, 0.5), 2.0);
  EXPECT_EQ(quantile_of({3.0, 1.0, 2.0}, 1.0), 3.0);
}

}  // namespace
}  // namespace hybridfusion::testing
