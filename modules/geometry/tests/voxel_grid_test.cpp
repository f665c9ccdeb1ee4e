#include <hybridfusion/geometry/voxel_grid.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(VoxelMean, AveragesEachOccupiedVoxelAndItsChannels) {
  PointCloud cloud;
  cloud.points = {{0.1F, 0.1F, 0.1F}, {0.3F, 0.1F, 0.1F}, {-0.1F, 0.1F, 0.1F}};
  cloud.colors = {{10, 0, 0}, {20, 0, 0}, {90, 0, 0}};
  cloud.times_s = {1.7e9, 1.7e9 + 2e-6, 5.0};
  const PointCloud mean = voxel_mean(cloud, 0.5);
  ASSERT_EQ(mean.size(), 2U);
  EXPECT_TRUE(mean.points[1].isApprox(Eigen::Vector3f(0.2F, 0.1F, 0.1F), 1e-6F));
  EXPECT_EQ(mean.colors[1][0], 15);
  EXPECT_NEAR(mean.times_s[1] - 1.7e9, 1e-6, 3e-7);  // double spacing at 1.7e9 s is 0.24 us
}

TEST(VoxelMean, DropsNonFinitePointsAndAcceptsAnEmptyCloud) {
  PointCloud cloud;
  EXPECT_TRUE(voxel_mean(cloud, 1.0).empty());
  cloud.points = {{std::numeric_limits<float>::infinity(), 0, 0}};
  EXPECT_TRUE(voxel_mean(cloud, 1.0).empty());
}

TEST(VoxelKey, SeparatesNeighboursAcrossTheOrigin) {
  EXPECT_NE(voxel_key({0, 0, 0}), voxel_key({-1, 0, 0}));
  EXPECT_NE(voxel_key({0, 0, -1}), voxel_key({0, -1, 0}));
  EXPECT_LT(voxel_key({-1, 5, 5}), voxel_key({0, -5, -5}));
}

TEST(VoxelMean, CloudsFarFromTheOriginOrWideKeepTheirPlaces) {
  // At 0.05 m the 21 bits of a key reach 52 km: 419 km off, and 105 km apart, cells would coincide.
  PointCloud cloud;
  cloud.points = {{419000.0F, 0.0F, 0.0F}, {419000.02F, 0.0F, 0.0F}, {-419000.0F, 5.0F, 0.0F}};
  cloud.points.emplace_back(419000.0F - 0.05F * static_cast<float>(1 << 21), 0.0F, 0.0F);
  const PointCloud mean = voxel_mean(cloud, 0.05);
  ASSERT_EQ(mean.size(), 3U);
  EXPECT_EQ(mean.points.front().x(), -419000.0F);
  EXPECT_NEAR(mean.points.back().x(), 419000.0F, 0.05F);
}

}  // namespace
}  // namespace hybridfusion
