#include "dense/sky_fringe.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr int kWidth = 120;
constexpr int kHeight = 100;
constexpr int kEaves = 60;    // first row of the wall
constexpr int kRailing = 48;  // first row of the bars on top of it
constexpr int kBarSpacing = 5;
constexpr Rgb8 kSky{250, 250, 255};
constexpr Rgb8 kBar{40, 40, 50};
constexpr double kMinGrey = 1.0;
constexpr int kReach_px = 16;

/// Camera axes (right, down, forward) of a photo whose axis rises by `pitch_rad`; z is up.
Rigid3 looking_north(double pitch_rad) {
  Eigen::Matrix3d axes;
  axes.col(0) = Eigen::Vector3d::UnitX();
  axes.col(2) = Eigen::Vector3d(0.0, std::cos(pitch_rad), std::sin(pitch_rad));
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return {Eigen::Quaterniond(axes), Eigen::Vector3d::Zero()};
}

bool is_bar(int x, int y) {
  return y >= kRailing && y < kEaves && x % kBarSpacing == 0;
}

/// A wall with a railing on top before the sky. The matcher gave the railing's depth to the sky
/// between its bars, too.
DepthMap railing_before_sky(double pitch_rad) {
  DepthMap map;
  map.grid = {.width_px = kWidth,
              .height_px = kHeight,
              .focal_px = 400.0,
              .principal_point_px = {kWidth / 2.0, kHeight / 2.0}};
  map.enu_from_camera = looking_north(pitch_rad);
  map.depth_m = {kWidth, kHeight, std::nanf("")};
  map.mask = {kWidth, kHeight, 255};
  map.rgb = {kWidth, kHeight, kSky};
  for (int y = kRailing; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      map.depth_m.at(x, y) = 20.0F;
      const auto stone = static_cast<std::uint8_t>(120 + (37 * x + 61 * y) % 90);
      if (y >= kEaves) map.rgb.at(x, y) = {stone, stone, stone};
      if (is_bar(x, y)) map.rgb.at(x, y) = kBar;
    }
  }
  map.grey = grey_plane(map.rgb);
  return map;
}

int depths_where(const DepthMap& map, const auto& wanted) {
  int count = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) count += map.has_depth(x, y) && wanted(x, y) ? 1 : 0;
  }
  return count;
}

bool between_bars(int x, int y) {
  return y >= kRailing && y < kEaves && !is_bar(x, y);
}
bool on_wall(int /*x*/, int y) {
  return y >= kEaves;
}

TEST(SkyFringe, GoesFromBetweenTheBarsAndLeavesTheBars) {
  const DepthMap before = railing_before_sky(0.1);
  DepthMap map = before;
  drop_sky_fringe(map, kMinGrey, kReach_px);
  EXPECT_EQ(depths_where(map, between_bars), 0);
  EXPECT_EQ(depths_where(map, is_bar), depths_where(before, is_bar));
  // The brightest stones right under the bars are nearer to the sky's colour than to the bars'.
  EXPECT_GT(depths_where(map, on_wall), depths_where(before, on_wall) * 98 / 100);
}

TEST(SkyFringe, IsSoughtWithinReachOnly) {
  DepthMap map = railing_before_sky(0.1);
  drop_sky_fringe(map, kMinGrey, 5);
  EXPECT_EQ(depths_where(map, [](int x, int y) { return between_bars(x, y) && y < kRailing + 2; }),
            0);
  EXPECT_GT(depths_where(map, [](int x, int y) { return between_bars(x, y) && y > kEaves - 4; }),
            0);
}

TEST(SkyFringe, NeedsAHorizon) {
  const DepthMap before = railing_before_sky(-std::numbers::pi / 3.0);  // bright ground, it is
  DepthMap map = before;
  drop_sky_fringe(map, kMinGrey, kReach_px);
  EXPECT_EQ(depths_where(map, between_bars), depths_where(before, between_bars));
}

TEST(SkyFringe, StaysWhenSwitchedOff) {
  const DepthMap before = railing_before_sky(0.1);
  DepthMap map = before;
  drop_sky_fringe(map, kMinGrey, 0);
  EXPECT_EQ(depths_where(map, between_bars), depths_where(before, between_bars));
}

TEST(SkyFringe, ABrightPaneInsideThePhotoIsNoSky) {
  DepthMap map = railing_before_sky(0.1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool frame = x < 25 || x >= kWidth - 25 || y < 25;
      if (!frame) continue;
      const auto stone = static_cast<std::uint8_t>(90 + (37 * x + 61 * y) % 90);
      map.rgb.at(x, y) = {stone, stone, stone};
      map.depth_m.at(x, y) = 20.0F;
    }
  }
  map.grey = grey_plane(map.rgb);
  const DepthMap before = map;
  drop_sky_fringe(map, kMinGrey, kReach_px);
  EXPECT_EQ(depths_where(map, between_bars), depths_where(before, between_bars));
}

}  // namespace
}  // namespace hybridfusion
