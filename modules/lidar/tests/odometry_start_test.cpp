#include "simulated_drive.hpp"
#include "street_world.hpp"

#include <hybridfusion/lidar/mapper.hpp>

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::DriveWorld;
using ::testing::HasSubstr;
using testing::rolling_street;
using testing::simulate_drive;
using testing::SimulatedDrive;

double length_of(const Trajectory& trajectory) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < trajectory.poses.size(); ++i) {
    length_m += (trajectory.poses[i].map_from_body.translation -
                 trajectory.poses[i - 1].map_from_body.translation)
                    .norm();
  }
  return length_m;
}

struct Result {
  MappingResult mapping = {};
  double path_ratio = 0.0;
  double tilt_deg = 0.0;

  [[nodiscard]] double level_sigma_deg() const { return mapping.level_sigma_rad * 180.0 / M_PI; }
};

Result map_drive(const SimulatedDrive& drive, const DriveWorld& world) {
  auto mapper = LidarMapper::create({}, drive.rig);
  EXPECT_TRUE(mapper);
  for (SensorMessage& message : testing::messages_of(drive)) mapper->add(std::move(message));
  auto mapping = mapper->finish({});
  EXPECT_TRUE(mapping) << mapping.error().message;
  if (!mapping) return {};
  Result out{.mapping = *std::move(mapping)};
  Trajectory truth = out.mapping.trajectory;
  const auto true_pose = [&](Timestamp time) {
    return world.pose(to_seconds(time - from_seconds(testing::kDriveStart_s)));
  };
  for (StampedPose& pose : truth.poses) pose.map_from_body = true_pose(pose.time);
  // A standing sensor's poses jitter by millimetres: there the way between first and last counts.
  const auto way = [](const Trajectory& t) {
    return (t.poses.back().map_from_body.translation - t.poses.front().map_from_body.translation)
        .norm();
  };
  out.path_ratio = way(truth) > 0.0 ? length_of(out.mapping.trajectory) / length_of(truth)
                                    : 1.0 + way(out.mapping.trajectory);
  const StampedPose& last = out.mapping.trajectory.poses.back();
  const Eigen::Vector3d up = last.map_from_body.rotation *
                             (true_pose(last.time).rotation.conjugate() * Eigen::Vector3d::UnitZ());
  out.tilt_deg = std::acos(std::min(1.0, up.z())) * 180.0 / M_PI;
  return out;
}

SimulatedDrive rolling_drive(const DriveWorld& world, double duration_s) {
  return simulate_drive(world, duration_s, 5);
}

class RollingStart : public ::testing::TestWithParam<double> {};

// Goals of the page on drives: path to 1 %, tilt to 0.5 degrees.
TEST_P(RollingStart, IsFoundAtAnySpeed) {
  const double speed_mps = GetParam();
  const DriveWorld world = rolling_street(3, speed_mps);
  const Result result = map_drive(rolling_drive(world, 5.0), world);
  EXPECT_TRUE(result.mapping.reliable);
  EXPECT_TRUE(result.mapping.odometry.used_imu);
  EXPECT_NEAR(result.path_ratio, 1.0, speed_mps > 0.0 ? 0.01 : 0.05);
  EXPECT_LT(result.tilt_deg, 3.0 * result.level_sigma_deg());
}

TEST_P(RollingStart, IsFoundWithAnImuOfTenSamplesASecond) {
  const DriveWorld world = rolling_street(4, GetParam());
  SimulatedDrive drive = rolling_drive(world, 5.0);
  std::vector<ImuSample> slow;
  for (std::size_t i = 0; i < drive.imu.size(); i += 20) slow.push_back(drive.imu[i]);
  drive.imu = slow;
  const Result result = map_drive(drive, world);
  EXPECT_TRUE(result.mapping.reliable);
  EXPECT_NEAR(result.path_ratio, 1.0, GetParam() > 0.0 ? 0.01 : 0.05);
  EXPECT_LT(result.tilt_deg, 3.0 * result.level_sigma_deg());
}

TEST_P(RollingStart, IsFoundWithoutAnImu) {
  const DriveWorld world = rolling_street(5, GetParam());
  SimulatedDrive drive = rolling_drive(world, 5.0);
  drive.imu.clear();
  drive.rig.imu_use = ImuUse::kNone;
  const Result result = map_drive(drive, world);
  EXPECT_TRUE(result.mapping.reliable);
  EXPECT_FALSE(result.mapping.odometry.used_imu);
  EXPECT_NEAR(result.path_ratio, 1.0, GetParam() > 0.0 ? 0.01 : 0.05);
  EXPECT_GT(result.mapping.level_sigma_rad, 0.0);
  EXPECT_LT(result.tilt_deg, 3.0 * result.level_sigma_deg());
}

INSTANTIATE_TEST_SUITE_P(Speeds, RollingStart, ::testing::Values(0.0, 4.0, 13.0, 28.0));

TEST(LidarMapper, NamesTheTurnOfAnImuThatIsMountedOtherwise) {
  const DriveWorld world = rolling_street(6, 6.0);
  SimulatedDrive drive = rolling_drive(world, 16.0);
  const Eigen::AngleAxisd turn(0.5 * M_PI, Eigen::Vector3d::UnitX());
  for (ImuSample& sample : drive.imu) {
    sample.angular_velocity_radps = turn.inverse() * sample.angular_velocity_radps;
    sample.specific_force_mps2 = turn.inverse() * sample.specific_force_mps2;
  }
  const Result result = map_drive(drive, world);
  EXPECT_FALSE(result.mapping.reliable);
  ASSERT_FALSE(result.mapping.contradictions.empty());
  const std::string& cause = result.mapping.contradictions.front();
  EXPECT_THAT(cause, HasSubstr("the IMU contradicts the LiDAR"));
  EXPECT_THAT(cause, HasSubstr("degrees about x"));
  EXPECT_THAT(cause, HasSubstr("imu_from_lidar: ["));
  EXPECT_THAT(cause, HasSubstr("lidar.imu=none"));
  EXPECT_NEAR(result.path_ratio, 1.0, 0.02);  // the LiDAR alone goes on
}

TEST(LidarMapper, DoubtsTwoImusThatTakeTurns) {
  const DriveWorld world = rolling_street(7, 8.0);
  SimulatedDrive drive = rolling_drive(world, 10.0);
  for (std::size_t i = 1; i < drive.imu.size(); i += 2) {
    const Eigen::Vector3d turned(-1.0, -1.0, 1.0);
    drive.imu[i].angular_velocity_radps = drive.imu[i].angular_velocity_radps.cwiseProduct(turned);
    drive.imu[i].specific_force_mps2 = drive.imu[i].specific_force_mps2.cwiseProduct(turned);
  }
  const Result result = map_drive(drive, world);
  // Half the acceleration and half the roll go missing; what is left may do for a gentle drive, but
  // a wrong path may not be called right.
  EXPECT_TRUE(!result.mapping.reliable || std::abs(result.path_ratio - 1.0) < 0.01);
}

TEST(LidarMapper, DoesNotInventAMotionForScansThatDoNotFitEachOther) {
  auto mapper = LidarMapper::create({}, {.imu_use = ImuUse::kNone});
  ASSERT_TRUE(mapper);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    // Each scan from another place, so that nothing leads from one to the next.
    const DriveWorld world = rolling_street(100 + seed, 5.0);
    LidarScan scan = simulate_drive(world, 1.0, seed).scans.back();
    for (LidarPoint& point : scan.points) {
      point.point_in_lidar =
          Eigen::AngleAxisf(0.9F * static_cast<float>(seed), Eigen::Vector3f::UnitX()) *
          point.point_in_lidar;
    }
    scan.stamp = from_seconds(1000.0 + 0.1 * static_cast<double>(seed));
    mapper->add(std::move(scan));
  }
  const auto mapping = mapper->finish({});
  EXPECT_TRUE(!mapping || !mapping->reliable);
}

}  // namespace
}  // namespace hybridfusion
