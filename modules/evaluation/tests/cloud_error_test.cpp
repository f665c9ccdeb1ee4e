#include <hybridfusion/evaluation/cloud_error.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A 10 m square of ground at z = 0 (label 0) and a wall of 10 x 10 m at x = 10 (label 1).
struct Corner {
  std::vector<Eigen::Vector3f> vertices = {
      {0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {10, 0, 10}, {10, 10, 10}};
  std::vector<std::array<std::uint32_t, 3>> triangles = {
      {0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  std::vector<std::uint8_t> labels = {0, 0, 1, 1};
  SurfaceDistance surface = SurfaceDistance::build(vertices, triangles).value();
};

TEST(CloudAccuracy, SplitsDistancesByTheNearestSurface) {
  const Corner corner;
  const std::vector<Eigen::Vector3f> cloud = {
      {2, 2, 0.1F}, {3, 2, 0.2F}, {4, 2, 0.3F}, {9.5F, 5, 5}, {NAN, 0, 0}};
  const auto result = cloud_accuracy(cloud, corner.surface, corner.labels);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->all.num_points, 4U);
  EXPECT_EQ(result->by_label[0].num_points, 3U);
  EXPECT_NEAR(result->by_label[0].median_m, 0.2, 1e-6);
  EXPECT_NEAR(result->by_label[1].mean_m, 0.5, 1e-6);
  EXPECT_NEAR(result->hard.mean_m, (0.1 + 0.2 + 0.3 + 0.5) / 4, 1e-6);
  EXPECT_TRUE(std::isnan(result->by_label[2].mean_m));
  EXPECT_TRUE(std::isnan(result->by_label[2].share_beyond[0]));
}

TEST(CloudAccuracy, CountsStrayPoints) {
  const Corner corner;
  const std::vector<Eigen::Vector3f> cloud = {{2, 2, 0.1F}, {3, 2, 0.6F}, {4, 5, 3.5F}, {4, 5, 0}};
  const auto result = cloud_accuracy(cloud, corner.surface, corner.labels);
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->all.share_beyond[0], 0.5);
  EXPECT_DOUBLE_EQ(result->all.share_beyond[1], 0.25);
}

TEST(CloudAccuracy, RefusesUnknownLabelsAndEmptyClouds) {
  const Corner corner;
  const std::vector<Eigen::Vector3f> cloud = {{1, 1, 1}};
  const std::vector<std::uint8_t> unknown = {0, 0, 9, 1};
  EXPECT_EQ(cloud_accuracy(cloud, corner.surface, unknown).error().code,
            ErrorCode::kInvalidOptions);
  EXPECT_EQ(cloud_accuracy({}, corner.surface, corner.labels).error().code,
            ErrorCode::kInsufficient);
}

TEST(CloudAccuracy, IsTheSameOnOneAndFourThreads) {
  const Corner corner;
  std::vector<Eigen::Vector3f> cloud;
  for (int i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(i);
    cloud.emplace_back(std::fmod(x * 0.37F, 10.0F), std::fmod(x * 0.71F, 10.0F), 0.001F * x);
  }
  const auto one = cloud_accuracy(cloud, corner.surface, corner.labels, {.num_threads = 1});
  const auto four = cloud_accuracy(cloud, corner.surface, corner.labels, {.num_threads = 4});
  ASSERT_TRUE(one && four);
  EXPECT_EQ(one->all.mean_m, four->all.mean_m);
  EXPECT_EQ(one->hard.percentile95_m, four->hard.percentile95_m);
}

TEST(CloudCompleteness, CountsSamplesThatHaveAPointNearby) {
  const std::vector<Eigen::Vector3f> samples = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const std::vector<Eigen::Vector3f> cloud = {{0, 0, 0.05F}, {1, 0, 0.15F}, {2, 0, 0.4F}};
  const auto result = cloud_completeness(samples, cloud);
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->share[0], 0.25);
  EXPECT_DOUBLE_EQ(result->share[1], 0.5);
  EXPECT_DOUBLE_EQ(result->share[2], 0.75);
  EXPECT_EQ(cloud_completeness(samples, {}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
