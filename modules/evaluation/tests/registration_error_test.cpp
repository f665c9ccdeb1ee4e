#include <hybridfusion/core/random.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rigid3_matchers.hpp>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Rigid3 yaw_and_shift(double yaw_rad, const Eigen::Vector3d& shift) {
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())),
          .translation = shift};
}

/// A drive along x for 10 s and points beside it, seen at the moment the vehicle passes.
struct Drive {
  Rigid3 truth_from_map = yaw_and_shift(0.3, {10.0, 20.0, 1.0});
  Trajectory estimate;
  Trajectory truth;
  PointCloud map;
};

Drive make_drive() {
  Drive drive;
  Random random(3, "drive");
  for (int i = 0; i <= 100; ++i) {
    const Rigid3 map_from_body = yaw_and_shift(0.0, {0.5 * i, 0.0, 0.0});
    drive.estimate.poses.push_back({from_seconds(0.1 * i), map_from_body});
    drive.truth.poses.push_back({from_seconds(0.1 * i), drive.truth_from_map * map_from_body});
  }
  for (int i = 0; i < 2000; ++i) {
    const double time_s = random.uniform(0.0, 10.0);
    drive.map.points.emplace_back(static_cast<float>(5.0 * time_s),
                                  static_cast<float>(random.uniform(-20, 20)),
                                  static_cast<float>(random.uniform(0, 10)));
    drive.map.times_s.push_back(time_s);
  }
  return drive;
}

TEST(RegistrationTruth, IsTheRigidTransformWhenNothingIsDistorted) {
  const Drive drive = make_drive();
  const auto places =
      true_places({drive.map, drive.estimate, drive.truth, drive.truth_from_map}, 80.0, 100000);
  ASSERT_TRUE(places);
  EXPECT_EQ(places->points_in_map.size(), drive.map.size());
  const Sim3 truth_from_vision{.translation = {1.0, 2.0, 3.0}};
  const auto truth = registration_truth(*places, truth_from_vision);
  ASSERT_TRUE(truth);
  const Rigid3 expected = Rigid3{.translation = {-1.0, -2.0, -3.0}} * drive.truth_from_map;
  EXPECT_THAT(truth->vision_from_lidar, Rigid3Near(expected, 1e-6, 1e-7));
  EXPECT_LT(truth->floor_rmse_m, 1e-6);
  EXPECT_NEAR(truth->scale_error, 0.0, 1e-8);
}

// A photo model 1 % too large about a point far above the scene: the truth must follow the scene.
TEST(RegistrationTruth, IsDefinedAtTheSceneAndStatesItsFloor) {
  const Drive drive = make_drive();
  const auto places =
      true_places({drive.map, drive.estimate, drive.truth, drive.truth_from_map}, 80.0, 500);
  ASSERT_TRUE(places);
  EXPECT_LE(places->points_in_map.size(), 500U);
  const Sim3 truth_from_vision{.translation = {0.0, 0.0, 0.65}, .scale = 1.0 / 1.01};
  const auto truth = registration_truth(*places, truth_from_vision);
  ASSERT_TRUE(truth);
  EXPECT_NEAR(truth->scale_error, 0.01, 1e-8);
  EXPECT_NEAR(
      truth->floor_rmse_m, 0.01 * std::sqrt(50. * 50 / 12 + 40. * 40 / 12 + 100. / 12), 0.02);
  // Where the world puts the centroid of L, seen through the similarity.
  Eigen::Vector3d mean_in_vision = Eigen::Vector3d::Zero();
  for (const auto& p : places->points_in_truth) mean_in_vision += truth_from_vision.inverse() * p;
  mean_in_vision /= static_cast<double>(places->points_in_truth.size());
  const Eigen::Vector3d at = truth->vision_from_lidar * truth->centroid_in_lidar;
  EXPECT_LT((at - mean_in_vision).norm(), 1e-6);
}

TEST(TruePlaces, ChargeDriftToTheMapWhenPointsHaveTimes) {
  Drive drive = make_drive();
  // The map bends upwards by 1 m over the drive.
  for (std::size_t i = 0; i < drive.estimate.poses.size(); ++i) {
    drive.estimate.poses[i].map_from_body.translation.z() += 0.01 * static_cast<double>(i);
  }
  for (std::size_t i = 0; i < drive.map.size(); ++i) {
    drive.map.points[i].z() += static_cast<float>(0.1 * drive.map.times_s[i]);
  }
  const auto places =
      true_places({drive.map, drive.estimate, drive.truth, drive.truth_from_map}, 80.0, 100000);
  ASSERT_TRUE(places);
  for (std::size_t i = 0; i < places->points_in_map.size(); ++i) {
    Eigen::Vector3d undrifted = places->points_in_map[i];
    undrifted.z() -= 0.1 * drive.map.times_s[i];
    EXPECT_LT((places->points_in_truth[i] - drive.truth_from_map * undrifted).norm(), 1e-4);
  }
}

TEST(TruePlaces, LeaveOutWhatIsFarFromTheDrive) {
  Drive drive = make_drive();
  drive.map.times_s.clear();
  drive.map.points = {{0, 79, 500}, {0, 81, 0}, {10, 0, 0}, {20, 0, 0}, {-70, 0, 0}};
  const auto places =
      true_places({drive.map, drive.estimate, drive.truth, drive.truth_from_map}, 80.0, 100);
  ASSERT_TRUE(places);
  EXPECT_EQ(places->points_in_map.size(), 4U);
  drive.map.points.resize(2);
  EXPECT_EQ(true_places({drive.map, drive.estimate, drive.truth, {}}, 80.0, 100).error().code,
            ErrorCode::kInsufficient);
}

TEST(RegistrationErrors, SplitHorizontalVerticalAndRotation) {
  const Rigid3 truth = yaw_and_shift(1.0, {3.0, 4.0, 5.0});
  const Rigid3 error{.translation = {0.03, 0.04, -0.12}};
  const auto errors = registration_errors(truth, truth * error, {100.0, 0.0, 0.0});
  EXPECT_NEAR(errors.horizontal_m, 0.05, 1e-9);
  EXPECT_NEAR(errors.vertical_m, -0.12, 1e-9);
  EXPECT_NEAR(errors.at_centroid_m, 0.13, 1e-9);
  EXPECT_NEAR(errors.rotation_deg, 0.0, 1e-6);
  EXPECT_TRUE(errors.success());
  EXPECT_FALSE(errors.precise());
  const auto turned =
      registration_errors(truth, truth * yaw_and_shift(0.01, {0, 0, 0}), {100.0, 0.0, 0.0});
  EXPECT_NEAR(turned.at_centroid_m, 1.0, 1e-3);  // 0.01 rad at 100 m
  EXPECT_NEAR(turned.rotation_deg, 0.01 * 180 / std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace hybridfusion
