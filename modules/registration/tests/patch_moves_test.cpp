#include "patch_moves.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A rim map with the outline of one house of 10 x 8 m, its corner at the origin, ridges of half
/// width 1 m.
VisionMaps house_map() {
  const RasterGrid grid = grid_over({-15.0, -15.0}, {25.0, 25.0}, 0.5);
  VisionMaps maps;
  maps.edge = {.grid = grid, .values = std::vector<float>(grid.size(), 0.0F)};
  maps.interior = maps.edge;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const Eigen::Vector2d p = grid.centre_of(x, y);
      const Eigen::Vector2d out =
          ((p - Eigen::Vector2d(5.0, 4.0)).cwiseAbs() - Eigen::Vector2d(5.0, 4.0));
      const double outside = out.cwiseMax(0.0).norm();
      const double inside = std::min(0.0, out.maxCoeff());
      const double distance = std::abs(outside + inside);
      maps.edge.values[grid.index(x, y)] = static_cast<float>(std::max(0.0, 1.0 - distance));
      if (inside < -1.5) maps.interior.values[grid.index(x, y)] = 1.0F;
    }
  }
  return maps;
}

/// Two walls of that house that meet at the origin, moved by (x, y).
PlanarPattern corner(double x, double y) {
  PlanarPattern pattern;
  for (double s = 0.25; s < 8.0; s += 0.5) {
    pattern.facades.push_back({{x + s, y}, {0.0, -1.0}, 1.0});
    pattern.facades.push_back({{x, y + s}, {-1.0, 0.0}, 1.0});
  }
  pattern.reach_m = 8.0;
  return pattern;
}

TEST(BestPlaceNearby, BringsACornerBackToItsRims) {
  const auto place =
      best_place_nearby(house_map(), corner(0.9, -0.7), Eigen::Vector2d::Zero(), 0.0, {}, {});
  ASSERT_TRUE(place);
  EXPECT_LT((place->position - Eigen::Vector2d(-0.9, 0.7)).norm(), 0.25);
  EXPECT_LT(std::abs(place->yaw_rad), 0.02);
  EXPECT_EQ(place->overhang_m, 0.0);
}

TEST(BestPlaceNearby, AWallAloneStaysAlongItself) {
  PlanarPattern wall;
  for (double s = 2.0; s < 8.0; s += 0.5) wall.facades.push_back({{s, 0.8}, {0.0, -1.0}, 1.0});
  wall.reach_m = 8.0;
  const auto place = best_place_nearby(house_map(), wall, Eigen::Vector2d::Zero(), 0.0, {}, {});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->position.y(), -0.8, 0.25);
  EXPECT_NEAR(place->position.x(), 0.0, 0.3);
}

TEST(BestPlaceNearby, SaysNothingWhereNoRimIsInReach) {
  EXPECT_FALSE(
      best_place_nearby(house_map(), corner(12.5, 11.5), Eigen::Vector2d::Zero(), 0.0, {}, {}));
}

TEST(PatternAround, KeepsWhatIsNearInTheFrameOfTheCentre) {
  PlanarPattern pattern = corner(0.0, 0.0);
  pattern.free_points = {{1.0, -2.0}, {50.0, 0.0}};
  // Turned by 90 degrees: the wall along x comes to lie along y.
  const PlanarPose pose{.position = {100.0, 0.0}, .yaw_rad = std::acos(0.0)};
  const PlanarPattern near = pattern_around(pattern, pose, {100.0, 4.0}, 4.0);
  ASSERT_FALSE(near.facades.empty());
  for (const PlanarPattern::Facade& f : near.facades) {
    EXPECT_LE(f.point.lpNorm<Eigen::Infinity>(), 4.0);
  }
  EXPECT_NEAR(near.facades.front().point.x(), 0.0, 1e-9);
  EXPECT_NEAR(near.facades.front().point.y(), -3.75, 1e-9);
  EXPECT_NEAR(near.facades.front().outward.x(), 1.0, 1e-9);
  ASSERT_EQ(near.free_points.size(), 1U);
  EXPECT_NEAR(near.free_points.front().x(), 2.0, 1e-9);
  EXPECT_NEAR(near.free_points.front().y(), -3.0, 1e-9);
}

}  // namespace
}  // namespace hybridfusion
