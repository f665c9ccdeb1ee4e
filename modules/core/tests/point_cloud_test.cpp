#include <hybridfusion/core/point_cloud.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

PointCloud two_points() {
  return {.points = {{1, 2, 3}, {4, 5, 6}}, .colors = {{1, 2, 3}, {4, 5, 6}}, .sigmas_m = {1, 2}};
}

TEST(PointCloud, AShortChannelIsInvalid) {
  PointCloud cloud = two_points();
  EXPECT_TRUE(validate(cloud));
  cloud.sigmas_m.pop_back();
  EXPECT_EQ(validate(cloud).error().code, ErrorCode::kInsufficient);
}

TEST(PointCloud, SelectKeepsTheChannelsInTheGivenOrder) {
  const PointCloud picked = select(two_points(), {1, 0});
  EXPECT_EQ(picked.points[0], Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(picked.colors[0], (Rgb8{4, 5, 6}));
  EXPECT_TRUE(picked.normals.empty());
}

TEST(PointCloud, KeepFlaggedIsSelectInPlace) {
  PointCloud cloud = concatenate(two_points(), two_points());
  cloud.points[2] = {7, 8, 9};
  const PointCloud selected = select(cloud, {1, 2});
  keep_flagged(cloud, {0, 1, 1, 0});
  EXPECT_EQ(cloud.points, selected.points);
  EXPECT_EQ(cloud.colors, selected.colors);
  EXPECT_EQ(cloud.sigmas_m, selected.sigmas_m);
  EXPECT_TRUE(cloud.normals.empty());
}

TEST(PointCloud, ConcatenateKeepsOnlyChannelsOfBoth) {
  PointCloud plain;
  plain.points = {{7, 8, 9}};
  plain.colors = {{7, 8, 9}};
  const PointCloud both = concatenate(two_points(), plain);
  EXPECT_EQ(both.size(), 3U);
  EXPECT_EQ(both.colors.size(), 3U);
  EXPECT_TRUE(both.sigmas_m.empty());
  EXPECT_TRUE(validate(both));
}

TEST(PointCloud, ASimilarityScalesPointsAndSigmasButNotNormals) {
  PointCloud cloud = two_points();
  cloud.normals = {{0, 0, 1}, {0, 0, 1}};
  const PointCloud mapped = transformed(Sim3{.translation = {1, 0, 0}, .scale = 2.0}, cloud);
  EXPECT_EQ(mapped.points[0], Eigen::Vector3f(3, 4, 6));
  EXPECT_EQ(mapped.sigmas_m[1], 4.0F);
  EXPECT_EQ(mapped.normals[0], Eigen::Vector3f(0, 0, 1));
}

TEST(PointCloud, NonFinitePointsAreDroppedWithTheirChannels) {
  PointCloud cloud = two_points();
  cloud.points[0].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(remove_non_finite(cloud), 1U);
  EXPECT_EQ(cloud.colors.front(), (Rgb8{4, 5, 6}));
}

}  // namespace
}  // namespace hybridfusion
