#include <hybridfusion/evaluation/supplement_degree.hpp>

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(OccupiedVolume, CountsEachCellOnceAcrossTheOrigin) {
  const std::vector<Eigen::Vector3f> points = {
      {0.1F, 0.1F, 0.1F}, {0.2F, 0.2F, 0.2F}, {-0.1F, 0.1F, 0.1F}};
  EXPECT_DOUBLE_EQ(occupied_volume_m3(points, 0.5), 2 * 0.125);
}

TEST(OccupiedVolume, IgnoresPointsThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points = {{0.1F, 0.1F, 0.1F}, {nan, 0.0F, 0.0F}};
  EXPECT_DOUBLE_EQ(occupied_volume_m3(points, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(occupied_volume_m3({}, 1.0), 0.0);
}

// Table I of the paper, row sim-building1: 217.49 m^3 -> 287.57 m^3 is printed as 32.21 %.
TEST(SupplementDegree, ReproducesThePaperTable) {
  EXPECT_NEAR(supplement_degree(287.57, 217.49), 0.3222, 2e-4);
}

TEST(CompareVolumes, LooksOnlyInsideTheRectangleOfTheLidarCloud) {
  // Two vision cells near the LiDAR cells, one 100 m away that must not count.
  const PointCloud vision{
      .points = {{0.25F, 0.25F, 0.25F}, {0.75F, 0.25F, 0.25F}, {100.0F, 0.0F, 0.0F}}};
  const PointCloud lidar{.points = {{0.25F, 0.25F, 0.25F}, {0.75F, 0.25F, 3.25F}}};
  const auto result = compare_volumes(vision, lidar, 0.5);
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->vision_volume_m3, 2 * 0.125);
  EXPECT_DOUBLE_EQ(result->fused_volume_m3, 3 * 0.125);
  EXPECT_DOUBLE_EQ(result->supplement_degree, 0.5);
  EXPECT_DOUBLE_EQ(result->extent_max.x(), 1.25);
}

TEST(CompareVolumes, RefusesCloudsThatDoNotOverlap) {
  const PointCloud far{.points = {{100.0F, 0.0F, 0.0F}}};
  const PointCloud lidar{.points = {{0.0F, 0.0F, 0.0F}}};
  ASSERT_FALSE(compare_volumes(far, lidar, 0.5));
  EXPECT_EQ(compare_volumes(far, {}, 0.5).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
