#include <hybridfusion/evaluation/boundary_accuracy.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(BoundaryAccuracy, IsTheMeanDistanceWithItsShareAndTrimmedMean) {
  const std::vector<Eigen::Vector2f> vision = {{0, 0}, {10, 0}, {20, 0}};
  const std::vector<Eigen::Vector2f> lidar = {{0, 0.2F}, {10, 0.4F}, {13, 0}};
  const BoundaryAccuracy result = boundary_accuracy(vision, lidar, 1.0);
  EXPECT_NEAR(result.mean_m, (0.2 + 0.4 + 3.0) / 3, 1e-6);
  EXPECT_NEAR(result.share_with_partner, 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(result.trimmed_mean_m, 0.3, 1e-6);
  EXPECT_EQ(result.distances_m.size(), 3U);
  EXPECT_EQ(result.num_outside, 0U);
}

TEST(BoundaryAccuracy, LeavesOutWhatLiesBeyondTheVisionCloud) {
  const std::vector<Eigen::Vector2f> vision = {{0, 0}, {10, 0}};
  const std::vector<Eigen::Vector2f> lidar = {{5, 0}, {50, 50}, {10.8F, 0}};
  const BoundaryAccuracy result = boundary_accuracy(vision, lidar, 1.0);
  EXPECT_EQ(result.num_lidar, 2U);
  EXPECT_EQ(result.num_outside, 1U);
  EXPECT_NEAR(result.mean_m, (5.0 + 0.8) / 2.0, 1e-6);
  const BoundaryAccuracy none = boundary_accuracy(vision, {{Eigen::Vector2f(50, 50)}}, 1.0);
  EXPECT_EQ(none.num_lidar, 0U);
  EXPECT_TRUE(std::isnan(none.mean_m) && std::isnan(none.trimmed_mean_m));
}

/// Flat ground of 60 m with a block of 20 x 20 x 8 m: seen from above, its roof; from the street,
/// its walls.
std::vector<Eigen::Vector3f> block(bool from_above, float shift_m) {
  std::vector<Eigen::Vector3f> points;
  for (float x = -30; x <= 30; x += 0.2F) {
    for (float y = -30; y <= 30; y += 0.2F) {
      const bool on_block = std::abs(x) <= 10 && std::abs(y) <= 10;
      if (from_above || !on_block) {
        points.emplace_back(x + shift_m, y, on_block ? 8.0F : 0.0F);
      }
    }
  }
  for (float t = -10; t <= 10 && !from_above; t += 0.2F) {
    for (float z = 0; z <= 8; z += 0.2F) {
      for (const float side : {-10.0F, 10.0F}) {
        points.emplace_back(side + shift_m, t, z);
        points.emplace_back(t + shift_m, side, z);
      }
    }
  }
  return points;
}

TEST(BoundaryAccuracy, GrowsWithTheShiftOfABlock) {
  const BoundaryAccuracyOptions options;
  const auto vision = standing_boundary(block(true, 0.0F), options);
  ASSERT_TRUE(vision);
  double previous = -1.0;
  for (const float shift_m : {0.0F, 0.5F, 1.0F, 2.0F}) {
    const auto lidar = standing_boundary(block(false, shift_m), options);
    ASSERT_TRUE(lidar);
    const double mean = boundary_accuracy(*vision, *lidar, 1.0).mean_m;
    EXPECT_GT(mean, previous);
    previous = mean;
  }
}

TEST(BoundaryAccuracy, RefusesAFieldWhereNothingStands) {
  std::vector<Eigen::Vector3f> field;
  for (float x = -30; x <= 30; x += 0.3F) {
    for (float y = -30; y <= 30; y += 0.3F) field.emplace_back(x, y, 0.0F);
  }
  EXPECT_EQ(standing_boundary(field, {}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
