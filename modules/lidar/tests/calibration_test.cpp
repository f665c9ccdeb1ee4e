#include "rig_fit.hpp"
#include "simulated_drive.hpp"
#include "street_world.hpp"

#include <hybridfusion/lidar/calibration.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::messages_of;
using testing::SimulatedDrive;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Long enough for a lap.
const SimulatedDrive& long_drive() {
  static const SimulatedDrive drive = testing::simulate_drive(26.0, 5);
  return drive;
}

Expected<RigCalibration> calibrate(const SimulatedDrive& drive, double clock_error_s) {
  OdometryOptions odometry;
  auto calibrator =
      RigCalibrator::create({.passes = 3, .max_points_per_scan = 1000}, odometry, drive.rig);
  if (!calibrator) return std::unexpected(calibrator.error());
  SimulatedDrive shifted = drive;
  for (ImuSample& sample : shifted.imu) sample.time -= from_seconds(clock_error_s);
  for (SensorMessage& message : messages_of(shifted)) calibrator->add(std::move(message));
  return calibrator->finish({});
}

TEST(RigCalibrator, FindsARigFiveDegreesTenCentimetresAndTwentyMillisecondsOff) {
  SimulatedDrive drive = long_drive();
  const Rigid3 truth = drive.rig.imu_from_lidar;
  const Eigen::AngleAxisd off(5.0 * kDegree, Eigen::Vector3d(1.0, -0.7, 0.8).normalized());
  drive.rig.imu_from_lidar.rotation = truth.rotation * Eigen::Quaterniond(off);
  drive.rig.imu_from_lidar.translation += Eigen::Vector3d(0.08, -0.06, 0.0);
  const auto found = calibrate(drive, 0.02);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(rotation_distance_rad(found->imu_from_lidar.rotation, truth.rotation), 0.3 * kDegree);
  EXPECT_NEAR(found->imu_time_offset_s, 0.02, 0.002);
  EXPECT_TRUE(found->time_offset.found);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(found->rotation[axis].found) << axis << ' ' << found->rotation[axis].sigma;
    const auto i = static_cast<Eigen::Index>(axis);
    const double error_m = found->imu_from_lidar.translation[i] - truth.translation[i];
    if (found->translation[axis].found) {
      EXPECT_LT(std::abs(error_m), 0.02) << axis;
    } else {
      // What the motion does not show stays as given.
      EXPECT_NEAR(
          found->imu_from_lidar.translation[i], drive.rig.imu_from_lidar.translation[i], 1e-6);
    }
  }
  // Turns about one axis do not show the lever arm along it.
  EXPECT_GT(found->translation[2].sigma, found->translation[0].sigma);
}

TEST(RigCalibrator, LeavesARightRigAlone) {
  const Rigid3 truth = long_drive().rig.imu_from_lidar;
  const auto found = calibrate(long_drive(), 0.0);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(rotation_distance_rad(found->imu_from_lidar.rotation, truth.rotation), 0.3 * kDegree);
  EXPECT_LT((found->imu_from_lidar.translation - truth.translation).norm(), 0.03);
  EXPECT_NEAR(found->imu_time_offset_s, 0.0, 0.002);
}

TEST(RigCalibrator, RefusesAStandstill) {
  // The 1.8 s before the vehicle moves off, over and over.
  SimulatedDrive still{.rig = long_drive().rig};
  for (int lap = 0; lap < 10; ++lap) {
    const Timestamp shift = from_seconds(1.8 * lap);
    for (std::size_t i = 0; i < 360; ++i) {
      still.imu.push_back(long_drive().imu[i]);
      still.imu.back().time += shift;
    }
    for (std::size_t i = 0; i < 18; ++i) {
      still.scans.push_back(long_drive().scans[i]);
      still.scans.back().stamp += shift;
    }
  }
  const auto found = calibrate(still, 0.0);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kDegenerate);
}

TEST(RigCalibrator, RefusesAStraightDriveThatNeverTurns) {
  // Houses of all sizes along a level road, steady speed from the first moment on.
  testing::DriveWorld world = testing::lookalike_street(8.0);
  world.pose = [](double t) { return Rigid3{.translation = {6.0 * t, 0.0, 1.2}}; };
  const auto found = calibrate(testing::simulate_drive(world, 20.0, 3), 0.0);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kDegenerate);
  EXPECT_NE(found.error().message.find("figure-eight"), std::string::npos);
}

TEST(RigCalibrator, RefusesTooShortADriveAndBadOptions) {
  const auto found = calibrate(testing::simulate_drive(4.0, 2), 0.0);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kInsufficient);
  EXPECT_EQ(RigCalibrator::create({.passes = 0}, {}, {}).error().code, ErrorCode::kInvalidOptions);
}

/// LiDAR poses and IMU of a motion with exact derivatives; `turn` scales its rotation.
struct ExactMotion {
  std::vector<LidarPose> poses = {};
  ImuBuffer imu = {};
};

ExactMotion exact_motion(const RigState& rig, double turn) {
  const auto imu_pose = [&](double t) {
    return Rigid3{.rotation = Eigen::Quaterniond(
                      Eigen::AngleAxisd(turn * std::sin(0.9 * t), Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(0.3 * turn * std::sin(1.3 * t), Eigen::Vector3d::UnitY()) *
                      Eigen::AngleAxisd(0.3 * turn * std::cos(1.7 * t), Eigen::Vector3d::UnitX())),
                  .translation = {4.0 * t + 2.0 * std::sin(0.7 * t), 0.0, 0.0}};
  };
  ExactMotion out;
  constexpr double kH = 1e-3;
  for (double t = -0.5; t < 30.5; t += 0.005) {
    const Rigid3 now = imu_pose(t);
    const Eigen::Vector3d acceleration =
        (imu_pose(t + kH).translation - 2.0 * now.translation + imu_pose(t - kH).translation) /
        (kH * kH);
    const Eigen::Matrix3d turned =
        (imu_pose(t - kH).rotation.conjugate() * imu_pose(t + kH).rotation).toRotationMatrix();
    (void)out.imu.add(
        {.time = from_seconds(100.0 + t - rig.imu_time_offset_s),
         .angular_velocity_radps = so3_log(turned) / (2.0 * kH) + rig.gyro_bias,
         .specific_force_mps2 =
             now.rotation.conjugate() * (acceleration - rig.gravity_in_map) + rig.accel_bias});
  }
  for (double t = 0.0; t < 30.0; t += 0.1) {
    out.poses.push_back(
        {.time = from_seconds(100.0 + t), .map_from_lidar = imu_pose(t) * rig.imu_from_lidar});
  }
  return out;
}

TEST(FitRig, RecoversEveryNumberFromExactMotion) {
  RigState truth;
  truth.imu_from_lidar = {.rotation = Eigen::Quaterniond(so3_exp({0.05, -0.1, 0.2})),
                          .translation = {0.2, -0.3, 0.4}};
  truth.imu_time_offset_s = 0.013;
  truth.gyro_bias = {0.004, -0.002, 0.003};
  truth.accel_bias = {0.05, -0.04, 0.03};
  truth.gravity_in_map = {0.0, 0.0, -9.80665};
  const ExactMotion motion = exact_motion(truth, 0.8);
  RigState given;
  given.imu_from_lidar.rotation = Eigen::Quaterniond(so3_exp({0.0, -0.05, 0.12}));
  given.imu_from_lidar.translation = {0.1, -0.2, 0.3};
  const auto fit = fit_rig(motion.poses, motion.imu, given, given, {});
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_LT(
      rotation_distance_rad(fit->state.imu_from_lidar.rotation, truth.imu_from_lidar.rotation),
      1e-3);
  EXPECT_LT((fit->state.imu_from_lidar.translation - truth.imu_from_lidar.translation).norm(),
            5e-3);
  EXPECT_NEAR(fit->state.imu_time_offset_s, truth.imu_time_offset_s, 2e-4);
  EXPECT_LT((fit->state.gyro_bias - truth.gyro_bias).norm(), 2e-4);
}

TEST(FitRig, AStraightDriveLeavesMountingAndClockOpen) {
  const RigState truth;
  const ExactMotion motion = exact_motion(truth, 0.0);
  const auto fit = fit_rig(motion.poses, motion.imu, truth, truth, {});
  ASSERT_TRUE(fit);
  // Nothing turns: the lever arm keeps its prior of half a metre.
  EXPECT_GT(std::sqrt(fit->covariance(rig::kTranslation, rig::kTranslation)), 0.1);
}

}  // namespace
}  // namespace hybridfusion
