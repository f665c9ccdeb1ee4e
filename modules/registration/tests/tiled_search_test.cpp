#include "tiled_search.hpp"

#include "street_scene.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A photo cloud of 120 x 120 m and a short drive in it, whose frame is turned and shifted.
struct Town {
  Town() {
    const test::Scene scene = test::make_scene(
        5, {.half_extent_m = 60.0, .lidar_half_extent_m = 40.0, .buildings = 70, .trees = 10});
    vision = scene.vision;
    truth = {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ())),
             .translation = {15.0, -8.0, 3.0}};
    lidar = transformed(truth.inverse(), scene.lidar);
    options.max_yaw_rad = std::numbers::pi;
  }

  PointCloud vision;
  PointCloud lidar;
  Rigid3 truth;
  RegistrationOptions options;
  /// Four tiles, smaller than what L covers.
  TileOptions tiles{.max_area_m2 = 5000.0, .tile_m = 70.0};
};

const Town& town() {
  static const Town made;
  return made;
}

TEST(TiledSearch, FindsThePlaceThatTheSearchOfTheWholeCloudFinds) {
  const Town& t = town();
  const auto whole = prepare_clouds(t.vision, t.lidar, {}, t.options, {});
  ASSERT_TRUE(whole) << whole.error().message;
  const auto expected = find_places(*whole, {}, t.options, {});
  ASSERT_TRUE(expected) << expected.error().message;
  auto clouds = prepare_lidar(t.lidar, {}, t.options, {});
  ASSERT_TRUE(clouds) << clouds.error().message;
  const auto found = find_places_in_tiles(t.vision.points, {}, t.options, t.tiles, {}, *clouds);
  ASSERT_TRUE(found) << found.error().message;
  const OutlinePlace& a = expected->places.front();
  const OutlinePlace& b = found->places.front();
  EXPECT_LT((a.planar.position - b.planar.position).norm(), 0.3);
  EXPECT_LT(std::abs(std::remainder(a.planar.yaw_rad - b.planar.yaw_rad, 2.0 * std::numbers::pi)),
            0.01);
  EXPECT_NEAR(b.score / a.score, 1.0, 0.05);
  // The margins of the tiles hold the same place: it must not come back as its own rival.
  ASSERT_GT(found->places.size(), 1U);
  EXPECT_LT(found->places[1].score, 0.8 * b.score);
  EXPECT_TRUE(clouds->vision.empty());
}

TEST(TiledSearch, RegistersAsTheWholeCloudDoes) {
  const Town& t = town();
  auto clouds = prepare_lidar(t.lidar, {}, t.options, {});
  ASSERT_TRUE(clouds);
  const auto result =
      register_in_tiles(t.vision.points, *std::move(clouds), t.lidar, {}, t.options, {}, t.tiles);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kOk) << result->reason;
  EXPECT_LT((result->vision_from_lidar.translation - t.truth.translation).norm(), 0.1);
  EXPECT_LT(rotation_distance_rad(result->vision_from_lidar.rotation, t.truth.rotation), 0.004);
}

TEST(TiledSearch, AnEqualPlaceInAnotherTileMakesThePositionAmbiguous) {
  const Town& t = town();
  // The same town again, with a void between that no tile can be made of.
  const PointCloud twice =
      concatenate(t.vision, transformed(Rigid3{.translation = {400.0, 0.0, 0.0}}, t.vision));
  auto clouds = prepare_lidar(t.lidar, {}, t.options, {});
  ASSERT_TRUE(clouds);
  const auto result =
      register_in_tiles(twice.points, *std::move(clouds), t.lidar, {}, t.options, {}, t.tiles);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kRefused);
  EXPECT_NE(result->reason.find("ambiguous"), std::string::npos) << result->reason;
  EXPECT_GT(*result->score("peak_ratio"), 0.95);
}

TEST(TiledSearch, IsUsedBeyondTheAreaOnlyAndRefusesWhatWouldTakeForever) {
  const Town& t = town();
  EXPECT_FALSE(needs_tiles(t.vision.points, t.options.outline));
  EXPECT_TRUE(needs_tiles(t.vision.points, t.options.outline, t.tiles));
  auto clouds = prepare_lidar(t.lidar, {}, t.options, {});
  ASSERT_TRUE(clouds);
  const auto found = find_places_in_tiles(
      t.vision.points, {}, t.options, {.tile_m = 10.0, .max_tiles = 100}, {}, *clouds);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
