#include <hybridfusion/evaluation/trajectory_error.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A circle of 20 m radius in 60 s, 10 poses a second, heading along the path, bobbing by 0.5 m so
/// that positions span three dimensions.
Trajectory circle(double step_s) {
  Trajectory result;
  for (int i = 0; i * step_s <= 60.0; ++i) {
    const double angle = 2.0 * std::numbers::pi * i * step_s / 60.0;
    result.poses.push_back(
        {.time = from_seconds(1000.0 + i * step_s),
         .map_from_body = {
             .rotation = Eigen::Quaterniond(
                 Eigen::AngleAxisd(angle + std::numbers::pi / 2, Eigen::Vector3d::UnitZ())),
             .translation = {
                 20 * std::cos(angle), 20 * std::sin(angle), 0.5 * std::sin(3 * angle)}}});
  }
  return result;
}

TEST(TrajectoryErrors, AreZeroForTheSamePathInAnotherFrame) {
  const Trajectory truth = circle(0.1);
  const Rigid3 map_from_truth{
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY())),
      .translation = {5.0, -3.0, 2.0}};
  Trajectory estimate = truth;
  for (StampedPose& pose : estimate.poses) pose.map_from_body = map_from_truth * pose.map_from_body;
  const auto errors = trajectory_errors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_EQ(errors->num_poses, truth.poses.size());
  EXPECT_LT(errors->ate_rmse_m, 1e-9);
  EXPECT_LT(errors->over_1_s.translation_rmse_m, 1e-9);
  EXPECT_NEAR(errors->tilt_deg, 0.02 * 180 / std::numbers::pi, 1e-6);
  EXPECT_EQ(errors->over_1_s.num_pairs, truth.poses.size() - 10);
  EXPECT_NEAR(errors->path_m, 2 * std::numbers::pi * 20, 0.6);
}

TEST(TrajectoryErrors, MeasureAScaledPath) {
  const Trajectory truth = circle(0.1);
  Trajectory estimate = truth;
  for (StampedPose& pose : estimate.poses) pose.map_from_body.translation *= 1.01;
  const auto errors = trajectory_errors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->scale_error, 0.01, 1e-6);
  EXPECT_NEAR(errors->ate_rmse_m, 0.2, 0.01);                      // 1 % of the radius
  EXPECT_NEAR(errors->over_1_s.translation_rmse_m, 0.021, 0.003);  // 1 % of 2.1 m a second
  EXPECT_LT(errors->rotation_rmse_deg, 0.1);
}

TEST(TrajectoryErrors, InterpolateTheTruthBetweenItsStamps) {
  const auto errors = trajectory_errors(circle(0.01), circle(0.1));
  ASSERT_TRUE(errors);
  EXPECT_LT(errors->ate_rmse_m, 1e-6);
}

TEST(TrajectoryErrors, AreDefinedOnAStraightStreet) {
  Trajectory truth;
  for (int i = 0; i < 100; ++i) {
    truth.poses.push_back(
        {.time = from_seconds(0.1 * i), .map_from_body = {.translation = {0.0, 1.0 * i, 0.0}}});
  }
  Trajectory estimate = truth;
  const Rigid3 map_from_truth{
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ())),
      .translation = {5.0, -3.0, 2.0}};
  for (StampedPose& pose : estimate.poses) pose.map_from_body = map_from_truth * pose.map_from_body;
  const auto errors = trajectory_errors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_LT(errors->ate_rmse_m, 1e-9);
  EXPECT_LT(errors->rotation_rmse_deg, 1e-6);
  EXPECT_EQ(errors->over_50_m.num_pairs, 50U);
}

TEST(TrajectoryErrors, RefuseATruthOfAnotherTime) {
  Trajectory late = circle(0.1);
  for (StampedPose& pose : late.poses) pose.time += from_seconds(1000.0);
  EXPECT_EQ(trajectory_errors(circle(0.1), late).error().code, ErrorCode::kInsufficient);
  EXPECT_EQ(trajectory_errors(circle(0.1), {}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
