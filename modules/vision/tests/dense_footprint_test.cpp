#include "dense/footprint.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

const PinholeGrid kGrid{
    .width_px = 100, .height_px = 80, .focal_px = 90.0, .principal_point_px = {49.5, 39.5}};

DepthMap random_map(std::uint64_t seed) {
  Random random(seed, "depths");
  DepthMap map;
  map.grid = kGrid;
  map.depth_m = {kGrid.width_px, kGrid.height_px, std::numeric_limits<float>::quiet_NaN()};
  for (float& depth : map.depth_m.values) {
    if (random.uniform() < 0.5) depth = static_cast<float>(random.uniform(5.0, 25.0));
  }
  return map;
}

Rigid3 random_pose(Random& random) {
  const auto signed_unit = [&] { return random.uniform(-1.0, 1.0); };
  const Eigen::Vector3d turn(signed_unit(), signed_unit(), signed_unit());
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(2.0 * turn.norm(), turn.normalized())),
          .translation = {15.0 * signed_unit(), 15.0 * signed_unit(), 15.0 * signed_unit()}};
}

bool any_point_in_photo(const DepthMap& map,
                        const DepthTile& tile,
                        int end_row,
                        const Rigid3& pose) {
  for (int y = 0; y < end_row; ++y) {
    for (int x = tile.begin_x; x < tile.end_x; ++x) {
      if (!map.has_depth(x, y)) continue;
      const Eigen::Vector3d ray = ray_of(map.grid, {x, y});
      const Eigen::Vector3d p = pose * (map.depth_m.at(x, y) * ray);
      if (!(p.z() > 0.0)) continue;
      const Eigen::Vector2d pixel = kGrid.focal_px * p.head<2>() / p.z() + kGrid.principal_point_px;
      if (pixel.x() > -1.0 && pixel.y() > -1.0 && pixel.x() < kGrid.width_px &&
          pixel.y() < kGrid.height_px) {
        return true;
      }
    }
  }
  return false;
}

TEST(Footprint, NeverCallsATileUnseenOfWhichAPointIsInThePhoto) {
  Random random(5, "poses");
  int culled = 0;
  int seen = 0;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    const DepthMap map = random_map(trial);
    const Rigid3 pose = random_pose(random);
    constexpr int kRows = 20;
    for (const DepthTile& tile : tiles_of_rows(map, 0, kRows)) {
      ASSERT_TRUE(tile.corners);
      std::array<Eigen::Vector3f, 8> corners = *tile.corners;
      for (Eigen::Vector3f& p : corners) p = (pose * p.cast<double>()).cast<float>();
      const bool in_photo = any_point_in_photo(map, tile, kRows, pose);
      if (!may_see(kGrid, corners)) {
        EXPECT_FALSE(in_photo) << trial;
        ++culled;
      }
      seen += in_photo ? 1 : 0;
    }
  }
  EXPECT_GT(culled, 100);
  EXPECT_GT(seen, 100);
}

TEST(Footprint, TilesCoverEveryColumnOnceAndSayWhereNothingIsKnown) {
  DepthMap map = random_map(1);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 64; ++x) map.depth_m.at(x, y) = std::numeric_limits<float>::quiet_NaN();
  }
  const auto tiles = tiles_of_rows(map, 0, 20);
  ASSERT_EQ(tiles.size(), 2U);
  EXPECT_EQ(tiles[0].begin_x, 0);
  EXPECT_EQ(tiles[0].end_x, tiles[1].begin_x);
  EXPECT_EQ(tiles[1].end_x, kGrid.width_px);
  EXPECT_FALSE(tiles[0].corners);
  EXPECT_TRUE(tiles[1].corners);
}

}  // namespace
}  // namespace hybridfusion
