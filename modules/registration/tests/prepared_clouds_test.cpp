#include "prepared_clouds.hpp"

#include "street_scene.hpp"

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// The ground of a square field, one point per `step_m`.
PointCloud field(float half_side_m, float step_m) {
  PointCloud cloud;
  for (float x = -half_side_m; x < half_side_m; x += step_m) {
    for (float y = -half_side_m; y < half_side_m; y += step_m)
      cloud.points.emplace_back(x, y, 0.0F);
  }
  return cloud;
}

TEST(PrepareClouds, ACoarsePoseLimitsTheVisionCloudToWhatTheSearchCanReach) {
  const PointCloud vision = field(300.0F, 0.8F);
  const PointCloud lidar = field(15.0F, 0.4F);  // reach: 2 x 42 + 20 + 20 m
  RegistrationInput input;
  const auto all = prepare_clouds(vision, lidar, input, {}, RunContext{});
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all->vision.size(), vision.size());
  input.vision_from_lidar_initial = Rigid3{.translation = {250.0, 0.0, 0.0}};
  const auto near = prepare_clouds(vision, lidar, input, {}, RunContext{});
  ASSERT_TRUE(near) << near.error().message;
  EXPECT_LT(near->vision.size(), vision.size() / 8);
  EXPECT_GT(near->vision.size(), vision.size() / 100);
  for (const Eigen::Vector3f& p : near->vision) EXPECT_GT(p.x(), 100.0F);
}

TEST(PrepareClouds, ACoarsePoseBesideTheVisionCloudIsDegenerate) {
  RegistrationInput input;
  input.vision_from_lidar_initial = Rigid3{.translation = {5000.0, 0.0, 0.0}};
  const auto clouds =
      prepare_clouds(field(50.0F, 0.5F), field(15.0F, 0.4F), input, {}, RunContext{});
  ASSERT_FALSE(clouds);
  EXPECT_EQ(clouds.error().code, ErrorCode::kDegenerate);
}

TEST(PrepareClouds, RefusesACloudWhoseRastersWouldNotFitInMemory) {
  const PointCloud wide = field(1e5F, 1e3F);
  const auto clouds = prepare_clouds(wide, field(15.0F, 0.4F), {}, {}, RunContext{});
  ASSERT_FALSE(clouds);
  EXPECT_EQ(clouds.error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
