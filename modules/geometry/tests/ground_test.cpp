#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/ground.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A field of 120 x 120 m, half of it under roofs 6-14 m high, on the given terrain.
template <class Terrain>
std::vector<Eigen::Vector3f> built_up(const Terrain& terrain, double noise_m) {
  Random random(7, "ground-test");
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 60000; ++i) {
    const double x = random.uniform(-60.0, 60.0);
    const double y = random.uniform(-60.0, 60.0);
    const bool is_roof = std::fmod(x + 60.0, 40.0) > 18.0 && std::fmod(y + 60.0, 30.0) > 10.0;
    const double roof = is_roof ? 6.0 + 2.0 * std::floor((x + 60.0) / 40.0) : 0.0;
    points.emplace_back(
        Eigen::Vector3d(x, y, terrain(x, y) + roof + noise_m * random.normal()).cast<float>());
  }
  return points;
}

TEST(FitGround, FollowsASlopeUnderBuildings) {
  const auto terrain = [](double x, double y) { return 12.0 + 0.08 * x - 0.05 * y; };
  const auto ground = fit_ground(built_up(terrain, 0.03));
  ASSERT_TRUE(ground) << ground.error().message;
  for (const double x : {-50.0, 0.0, 50.0}) {
    for (const double y : {-50.0, 0.0, 50.0}) {
      // An 8th percentile in a 2 m cell lies below the mean by noise and half a cell of slope.
      EXPECT_NEAR(ground->height_at(x, y), terrain(x, y), 0.2) << x << " " << y;
    }
  }
  EXPECT_LT(ground->rms_m, 0.2);
}

TEST(FitGround, FollowsRollingTerrainWithItsTiles) {
  const auto terrain = [](double x, double y) {
    return 1.5 * std::sin(x / 35.0) + 0.01 * y + 2e-4 * x * x;
  };
  const auto ground = fit_ground(built_up(terrain, 0.02));
  ASSERT_TRUE(ground) << ground.error().message;
  double worst = 0.0;
  for (double x = -50.0; x <= 50.0; x += 10.0) {
    for (double y = -50.0; y <= 50.0; y += 10.0) {
      worst = std::max(worst, std::abs(ground->height_at(x, y) - terrain(x, y)));
    }
  }
  EXPECT_LT(worst, 0.4);
}

TEST(FitGround, IgnoresAFewPointsFarBelowAndFarAway) {
  const auto terrain = [](double, double) { return 3.0; };
  std::vector<Eigen::Vector3f> points = built_up(terrain, 0.02);
  for (int i = 0; i < 100; ++i) points.emplace_back(1e4F + static_cast<float>(i), 0.0F, -40.0F);
  points.emplace_back(std::nanf(""), 0.0F, 0.0F);
  const auto ground = fit_ground(points);
  ASSERT_TRUE(ground) << ground.error().message;
  EXPECT_NEAR(ground->height_at(0.0, 0.0), 3.0, 0.1);
}

TEST(FitGround, RefusesACloudWithoutGround) {
  EXPECT_EQ(fit_ground({}).error().code, ErrorCode::kInsufficient);
  const std::vector<Eigen::Vector3f> few(4, Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(fit_ground(few).error().code, ErrorCode::kInsufficient);
}

TEST(FitGround, RefusesOptionsOutOfRange) {
  EXPECT_EQ(fit_ground({}, {.cell_m = -1.0}).error().code, ErrorCode::kInvalidOptions);
}

TEST(HeightsAbove, AreMeasuredFromTheGround) {
  GroundModel ground;
  ground.surface[0] = 5.0;
  const std::vector<Eigen::Vector3f> points = {{0.0F, 0.0F, 7.5F}};
  EXPECT_FLOAT_EQ(heights_above(ground, points).front(), 2.5F);
}

}  // namespace
}  // namespace hybridfusion
