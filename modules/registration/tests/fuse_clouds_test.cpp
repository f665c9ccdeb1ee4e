#include <hybridfusion/registration/fuse_clouds.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A wall in the plane x = `x`, y in [0, 4], z in [z0, z1], one point per 0.1 m.
PointCloud wall(float x, float z0, float z1) {
  PointCloud cloud;
  for (float y = 0.0F; y < 4.0F; y += 0.1F) {
    for (float z = z0; z < z1; z += 0.1F) cloud.points.emplace_back(x, y, z);
  }
  return cloud;
}

std::size_t count(const PointCloud& cloud, PointSource source) {
  return static_cast<std::size_t>(std::ranges::count(cloud.sources, source));
}

TEST(FuseClouds, KeepsOneWallWhereBothSeeItAndWhatOnlyOneSees) {
  const PointCloud vision = wall(0.08F, 2.0F, 8.0F);  // 8 cm off, reaching higher
  const PointCloud lidar = wall(0.0F, 0.0F, 5.0F);
  const auto fused = fuse_clouds(vision, lidar, Rigid3{});
  ASSERT_TRUE(fused) << fused.error().message;
  EXPECT_EQ(fused->lidar_dropped, 0U);
  EXPECT_EQ(count(fused->cloud, PointSource::kLidar), lidar.size());
  EXPECT_GT(fused->vision_dropped, vision.size() / 3);
  for (std::size_t i = 0; i < fused->cloud.size(); ++i) {
    if (fused->cloud.sources[i] == PointSource::kVision) {
      EXPECT_GT(fused->cloud.points[i].z(), 4.9F);
    }
  }
}

TEST(FuseClouds, PhotoPointsFillGapsBetweenLidarPointsOnTheLidarSurface) {
  PointCloud lidar;  // one point per 0.25 m: a wall seen from far away
  for (float y = 0.0F; y < 4.0F; y += 0.25F) {
    for (float z = 0.0F; z < 4.0F; z += 0.25F) lidar.points.emplace_back(0.0F, y, z);
  }
  const PointCloud vision = wall(0.08F, 0.0F, 4.0F);
  const auto fused = fuse_clouds(vision, lidar, Rigid3{});
  ASSERT_TRUE(fused) << fused.error().message;
  EXPECT_GT(fused->vision_dropped, 0U);
  EXPECT_GT(count(fused->cloud, PointSource::kVision), vision.size() / 2);
  for (const Eigen::Vector3f& p : fused->cloud.points) {
    // At the rims of the wall the nearest LiDAR points are a line, not a plane.
    if (p.y() < 3.5F && p.z() < 3.5F && p.y() > 0.25F && p.z() > 0.25F) {
      EXPECT_NEAR(p.x(), 0.0F, 1e-4F);
    }
  }
  const auto thin = fuse_clouds(vision, lidar, Rigid3{}, {}, {.fill_gap_m = 100.0});
  ASSERT_TRUE(thin) << thin.error().message;
  EXPECT_LT(count(thin->cloud, PointSource::kVision), vision.size() / 10);
}

TEST(FuseClouds, TheSmallerSigmaWins) {
  PointCloud vision = wall(0.05F, 0.0F, 4.0F);
  PointCloud lidar = wall(0.0F, 0.0F, 4.0F);
  vision.sigmas_m.assign(vision.size(), 0.01F);
  lidar.sigmas_m.assign(lidar.size(), 0.10F);
  const auto fused = fuse_clouds(vision, lidar, Rigid3{});
  ASSERT_TRUE(fused) << fused.error().message;
  EXPECT_EQ(fused->vision_dropped, 0U);
  EXPECT_EQ(count(fused->cloud, PointSource::kLidar), 0U);
}

TEST(FuseClouds, NarrowGapsAreInterpolatedBehindTheMeasuredPointsUnlessSwitchedOff) {
  PointCloud lidar;  // scan lines 0.25 m apart
  for (float y = 0.0F; y < 4.0F; y += 0.05F) {
    for (float z = 0.0F; z < 3.0F; z += 0.25F) lidar.points.emplace_back(0.0F, y, z);
  }
  FuseOptions options;
  const auto filled = fuse_clouds(wall(0.0F, 5.0F, 6.0F), lidar, Rigid3{}, {}, options);
  options.interpolation.enabled = false;
  const auto measured = fuse_clouds(wall(0.0F, 5.0F, 6.0F), lidar, Rigid3{}, {}, options);
  ASSERT_TRUE(filled && measured);
  EXPECT_EQ(measured->interpolated, 0U);
  EXPECT_GT(filled->interpolated, 200U);
  EXPECT_EQ(filled->cloud.size(), measured->cloud.size() + filled->interpolated);
  for (std::size_t i = 0; i < filled->cloud.size(); ++i) {
    EXPECT_EQ(filled->cloud.sources[i] == PointSource::kInterpolated, i >= measured->cloud.size());
    if (i < measured->cloud.size()) {
      EXPECT_EQ(filled->cloud.points[i], measured->cloud.points[i]);
    }
  }
}

TEST(FuseClouds, LidarPointsBorrowTheColourOfNearVisionPoints) {
  PointCloud vision = wall(0.08F, 0.0F, 4.0F);
  vision.colors.assign(vision.size(), {10, 20, 30});
  PointCloud lidar = wall(0.0F, 0.0F, 4.0F);
  lidar.points.emplace_back(50.0F, 0.0F, 0.0F);
  const auto fused = fuse_clouds(vision, lidar, Rigid3{});
  ASSERT_TRUE(fused) << fused.error().message;
  for (std::size_t i = 0; i < fused->cloud.size(); ++i) {
    const bool is_far = fused->cloud.points[i].x() > 10.0F;
    EXPECT_EQ(fused->cloud.colors[i], is_far ? (Rgb8{128, 128, 128}) : (Rgb8{10, 20, 30}));
  }
}

TEST(FuseClouds, KeepsSurfacesThatAreApart) {
  const auto fused = fuse_clouds(wall(1.0F, 0.0F, 4.0F), wall(0.0F, 0.0F, 4.0F), Rigid3{});
  ASSERT_TRUE(fused) << fused.error().message;
  EXPECT_EQ(fused->vision_dropped + fused->lidar_dropped, 0U);
}

TEST(FuseClouds, MapsTheLidarAndRescalesTheVisionCloud) {
  PointCloud vision;
  vision.points = {{10.0F, 0.0F, 0.0F}};
  vision.colors = {{1, 2, 3}};
  PointCloud lidar;
  lidar.points = {{0.0F, 0.0F, 0.0F}};
  lidar.intensities = {7.0F};
  Rigid3 pose;
  pose.translation = {0.0, 5.0, 0.0};
  const auto fused = fuse_clouds(vision, lidar, pose, Sim3{.scale = 1.1});
  ASSERT_TRUE(fused) << fused.error().message;
  ASSERT_EQ(fused->cloud.size(), 2U);
  EXPECT_FLOAT_EQ(fused->cloud.points[0].x(), 11.0F);
  EXPECT_FLOAT_EQ(fused->cloud.points[1].y(), 5.0F);
  EXPECT_EQ(fused->cloud.colors[0], (Rgb8{1, 2, 3}));
  EXPECT_FLOAT_EQ(fused->cloud.intensities[1], 7.0F);
  EXPECT_EQ(fused->cloud.sources[0], PointSource::kVision);
  EXPECT_EQ(fused->cloud.sources[1], PointSource::kLidar);
}

TEST(FuseClouds, AcceptsAnEmptyCloudAndRefusesBrokenChannels) {
  EXPECT_EQ(fuse_clouds(PointCloud{}, wall(0.0F, 0.0F, 1.0F), Rigid3{})->vision_dropped, 0U);
  PointCloud broken = wall(0.0F, 0.0F, 1.0F);
  broken.intensities = {1.0F};
  EXPECT_FALSE(fuse_clouds(broken, broken, Rigid3{}));
}

TEST(FuseClouds, IsTheSameAtAnyThreadCount) {
  RunContext one;
  one.num_threads = 1;
  RunContext four;
  four.num_threads = 4;
  const PointCloud vision = wall(0.1F, 1.0F, 6.0F);
  const PointCloud lidar = wall(0.0F, 0.0F, 5.0F);
  EXPECT_EQ(fuse_clouds(vision, lidar, Rigid3{}, {}, {}, one)->cloud.points,
            fuse_clouds(vision, lidar, Rigid3{}, {}, {}, four)->cloud.points);
}

}  // namespace
}  // namespace hybridfusion
