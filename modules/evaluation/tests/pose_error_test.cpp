#include <hybridfusion/core/random.hpp>
#include <hybridfusion/evaluation/pose_error.hpp>

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

std::vector<Rigid3> random_cameras(std::size_t count) {
  Random random(1, "cameras");
  std::vector<Rigid3> cameras(count);
  for (Rigid3& camera : cameras) {
    camera.translation = {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(60, 70)};
    camera.rotation = Eigen::Quaterniond(
        Eigen::AngleAxisd(random.uniform(0, 3), Eigen::Vector3d(1, 0.2, 0.1).normalized()));
  }
  return cameras;
}

TEST(CameraErrors, SeparatesGeoreferenceScaleAndShape) {
  const std::vector<Rigid3> truth = random_cameras(20);
  const Sim3 estimate_from_truth{
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX())),
      .translation = {2.0, 0.0, -1.0},
      .scale = 1.003};
  std::vector<Rigid3> estimate;
  for (const Rigid3& camera : truth) estimate.push_back(estimate_from_truth.map_pose(camera));
  const auto errors = camera_errors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_LT(errors->similarity_rmse_m, 1e-9);
  EXPECT_NEAR(errors->scale_error, 0.003, 1e-9);
  EXPECT_NEAR(errors->tilt_deg, 0.01 * 180.0 / std::numbers::pi, 1e-6);
  EXPECT_LT(errors->rotation_max_deg, 1e-6);
  EXPECT_GT(errors->rigid_rmse_m, 0.05);  // 0.3 % of a spread of about 40 m
  EXPECT_LT(errors->rigid_rmse_m, 0.20);
  EXPECT_GT(errors->absolute_rmse_m, 1.0);
}

TEST(CameraErrors, MeasuresCentreNoiseAndOneTurnedCamera) {
  const std::vector<Rigid3> truth = random_cameras(200);
  std::vector<Rigid3> estimate = truth;
  Random random(2, "noise");
  for (Rigid3& camera : estimate) {
    camera.translation += Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  estimate.front().rotation =
      truth.front().rotation * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ());
  const auto errors = camera_errors(truth, estimate);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->absolute_rmse_m, std::sqrt(3.0), 0.15);
  EXPECT_NEAR(errors->absolute_horizontal_rmse_m, std::sqrt(2.0), 0.15);
  EXPECT_NEAR(errors->absolute_vertical_rmse_m, 1.0, 0.15);
  EXPECT_NEAR(errors->rotation_max_deg, 5.73, 0.5);
  EXPECT_LT(errors->rotation_median_deg, 1.0);
}

TEST(CameraErrors, RefusesTwoCameras) {
  const std::vector<Rigid3> truth = random_cameras(2);
  EXPECT_EQ(camera_errors(truth, truth).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
