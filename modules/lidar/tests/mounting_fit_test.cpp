#include "mounting_fit.hpp"

#include "manifold.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using ::testing::HasSubstr;

/// A drive round a block with the noise of scan poses and of a vibrating vehicle.
std::vector<MotionPair> drive(const Eigen::Matrix3d& measured_from_given, double gyro_factor) {
  Random random(7, "test/mounting_fit");
  const auto noise = [&](double sigma) {
    return Eigen::Vector3d(
        sigma * random.normal(), sigma * random.normal(), sigma * random.normal());
  };
  std::vector<MotionPair> pairs;
  Eigen::Matrix3d map_from_imu = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 300; ++i) {
    const double yaw_rate = i % 100 < 30 ? 0.4 : 0.0;
    const Eigen::Vector3d turn(
        0.004 * std::sin(0.3 * i), 0.004 * std::cos(0.2 * i), 0.1 * yaw_rate);
    const Eigen::Vector3d acceleration(0.5 * std::sin(0.05 * i), 7.0 * yaw_rate, 0.0);
    map_from_imu = map_from_imu * so3_exp(turn);
    const Eigen::Vector3d force =
        acceleration + 9.81 * (map_from_imu.transpose() * Eigen::Vector3d::UnitZ());
    pairs.push_back({.duration_s = 0.1,
                     .turn_by_gyro_rad = gyro_factor * (measured_from_given * (turn + noise(5e-4))),
                     .turn_by_lidar_rad = turn + noise(3e-3),
                     .force_mps2 = measured_from_given * (force + noise(0.5)),
                     .acceleration_mps2 = acceleration + noise(1.0),
                     .map_from_imu = map_from_imu});
  }
  return pairs;
}

TEST(FitMounting, FindsAnyTurnOfTheAxes) {
  Random random(8, "test/mounting_turns");
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d vector(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d turn = so3_exp(1.5 * vector);
    const auto fit = fit_mounting(drive(turn.transpose(), 1.0));
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit->mirrored);
    EXPECT_LT(so3_log(fit->given_from_measured.transpose() * turn).norm(), 0.05) << i;
  }
}

TEST(FitMounting, NamesQuarterTurnsMirrorsAndDegrees) {
  const Eigen::Matrix3d quarter = so3_exp(0.5 * M_PI * Eigen::Vector3d::UnitY());
  EXPECT_THAT(mounting_text(*fit_mounting(drive(quarter.transpose(), 1.0))),
              HasSubstr("rotated by about 90 degrees about y"));
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1.0, -1.0, 1.0).asDiagonal();
  EXPECT_THAT(mounting_text(*fit_mounting(drive(mirror, 1.0))), HasSubstr("mirrored"));
  EXPECT_THAT(mounting_text(*fit_mounting(drive(Eigen::Matrix3d::Identity(), 180.0 / M_PI))),
              HasSubstr("degrees, not radians"));
}

TEST(FitMounting, SaysNothingAboutADriveThatDoesNotTurnOrAnImuThatDoesNotMeasure) {
  std::vector<MotionPair> straight = drive(Eigen::Matrix3d::Identity(), 1.0);
  for (MotionPair& pair : straight) pair.turn_by_lidar_rad.setZero();
  EXPECT_FALSE(fit_mounting(straight));
  std::vector<MotionPair> dead = drive(Eigen::Matrix3d::Identity(), 1.0);
  for (MotionPair& pair : dead) {
    pair.turn_by_gyro_rad.setZero();
    pair.force_mps2.setZero();
  }
  EXPECT_FALSE(fit_mounting(dead));
}

}  // namespace
}  // namespace hybridfusion
