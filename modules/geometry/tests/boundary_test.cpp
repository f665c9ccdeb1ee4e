#include <hybridfusion/geometry/boundary.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

std::vector<Eigen::Vector2f> filled_square(float side_m, float step_m) {
  std::vector<Eigen::Vector2f> points;
  for (float x = 0.0F; x <= side_m; x += step_m) {
    for (float y = 0.0F; y <= side_m; y += step_m) points.emplace_back(x, y);
  }
  return points;
}

TEST(BoundaryPoints, OfASquareAreItsRim) {
  const std::vector<Eigen::Vector2f> boundary =
      boundary_points(filled_square(10.0F, 0.25F), {.radius_m = 1.0, .thin_m = 0.1});
  // 41 grid points a side: 160 on the rim.
  EXPECT_EQ(boundary.size(), 160U);
  for (const Eigen::Vector2f& p : boundary) {
    const float inset = std::min({p.x(), p.y(), 10.0F - p.x(), 10.0F - p.y()});
    EXPECT_NEAR(inset, 0.0F, 1e-4F);
  }
}

TEST(BoundaryPoints, IncludeTheRimOfAHole) {
  std::vector<Eigen::Vector2f> points = filled_square(10.0F, 0.25F);
  std::erase_if(points, [](const Eigen::Vector2f& p) {
    return (p - Eigen::Vector2f(5.0F, 5.0F)).norm() < 2.0F;
  });
  const std::vector<Eigen::Vector2f> boundary = boundary_points(points, {.thin_m = 0.1});
  const auto near_hole = std::ranges::count_if(boundary, [](const Eigen::Vector2f& p) {
    return (p - Eigen::Vector2f(5.0F, 5.0F)).norm() < 2.5F;
  });
  EXPECT_GT(near_hole, 20);
}

TEST(BoundaryPoints, OfNothingAndOfLonePointsAreEmpty) {
  EXPECT_TRUE(boundary_points({}).empty());
  const std::vector<Eigen::Vector2f> lone = {{0.0F, 0.0F}, {50.0F, 0.0F}, {std::nanf(""), 1.0F}};
  EXPECT_TRUE(boundary_points(lone).empty());
}

TEST(BoundaryPoints, AreTheSameAtAnyThreadCount) {
  RunContext one;
  one.num_threads = 1;
  RunContext four;
  four.num_threads = 4;
  const std::vector<Eigen::Vector2f> points = filled_square(20.0F, 0.3F);
  EXPECT_EQ(boundary_points(points, {}, one), boundary_points(points, {}, four));
}

TEST(ElevatedBoundary, LeavesTheGroundOut) {
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector2f& p : filled_square(20.0F, 0.25F)) {
    const bool is_roof = std::abs(p.x() - 10.0F) < 3.0F && std::abs(p.y() - 10.0F) < 3.0F;
    points.emplace_back(p.x(), p.y(), is_roof ? 6.0F : 0.0F);
  }
  const std::vector<Eigen::Vector2f> boundary = elevated_boundary(points, GroundModel{});
  ASSERT_FALSE(boundary.empty());
  for (const Eigen::Vector2f& p : boundary) {
    const float reach = (p - Eigen::Vector2f(10.0F, 10.0F)).lpNorm<Eigen::Infinity>();
    EXPECT_NEAR(reach, 3.0F, 0.3F);
  }
}

}  // namespace
}  // namespace hybridfusion
