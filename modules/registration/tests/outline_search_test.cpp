#include "outline_search.hpp"

#include "ground_alignment.hpp"
#include "raster.hpp"
#include "street_scene.hpp"

#include <hybridfusion/geometry/ground.hpp>

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

Raster constant_raster(int width, int height, float value) {
  Raster raster{{.origin = {0.0, 0.0}, .cell_m = 1.0, .width = width, .height = height}, {}};
  raster.values.assign(raster.grid.size(), value);
  return raster;
}

TEST(Raster, SamplesBilinearlyBetweenCellCentresAndZeroOutside) {
  Raster raster = constant_raster(3, 2, 0.0F);
  raster.values[raster.grid.index(1, 0)] = 4.0F;
  EXPECT_FLOAT_EQ(raster.sample(1.5, 0.5), 4.0F);
  EXPECT_FLOAT_EQ(raster.sample(2.0, 0.5), 2.0F);
  EXPECT_FLOAT_EQ(raster.sample(1.5, 0.0), 2.0F);  // half of it lies over the border
  EXPECT_FLOAT_EQ(raster.sample(-5.0, 0.5), 0.0F);
  EXPECT_TRUE(std::isnan(raster.nearest(-0.1, 0.5)));
}

TEST(Raster, BlurKeepsTheSumAwayFromTheBorder) {
  Raster raster = constant_raster(21, 21, 0.0F);
  raster.values[raster.grid.index(10, 10)] = 1.0F;
  blur(raster, 1.5);
  double sum = 0.0;
  for (const float value : raster.values) sum += static_cast<double>(value);
  EXPECT_NEAR(sum, 1.0, 1e-5);
  EXPECT_FLOAT_EQ(raster.at(8, 10), raster.at(10, 8));
}

TEST(Raster, HalvedCellsAreMeansOfFourWithNothingBeyondTheEdge) {
  const Raster raster{.grid = {.origin = {3.0, -1.0}, .cell_m = 0.5, .width = 3, .height = 2},
                      .values = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}};
  const Raster half = halved(raster);
  EXPECT_EQ(half.grid.origin, raster.grid.origin);
  EXPECT_EQ(half.grid.cell_m, 1.0);
  EXPECT_EQ(half.grid.width, 2);
  EXPECT_EQ(half.grid.height, 1);
  EXPECT_EQ(half.values, (std::vector<float>{3.0F, 2.25F}));
}

TEST(Raster, ErodeShrinksABlockByItsRadius) {
  Raster raster = constant_raster(11, 11, 0.0F);
  for (int y = 2; y < 9; ++y) {
    for (int x = 2; x < 9; ++x) raster.values[raster.grid.index(x, y)] = 1.0F;
  }
  erode(raster, 1.2);
  EXPECT_EQ(raster.at(2, 5), 0.0F);
  EXPECT_EQ(raster.at(3, 5), 1.0F);
  EXPECT_EQ(raster.at(3, 3), 1.0F);
}

TEST(Raster, FillSmallHolesTakesTheMedianOfKnownNeighbours) {
  Raster raster = constant_raster(3, 3, 2.0F);
  raster.values[raster.grid.index(1, 1)] = kUnknown;
  raster.values[raster.grid.index(0, 0)] = 50.0F;
  fill_small_holes(raster, 4, 1);
  EXPECT_FLOAT_EQ(raster.at(1, 1), 2.0F);
}

struct SmallBlock {
  VisionMaps coarse;
  VisionMaps fine;
  LidarMaps lidar;
};

SmallBlock small_block(std::uint64_t seed) {
  const test::Scene scene =
      test::make_scene(seed, {.half_extent_m = 35.0, .lidar_half_extent_m = 40.0});
  const OutlineOptions options;
  const auto vision_ground = fit_ground(scene.vision.points);
  const auto lidar_ground = fit_ground(scene.lidar.points);
  const std::vector<float> vision_h = heights_above(*vision_ground, scene.vision.points);
  const std::vector<float> lidar_h = heights_above(*lidar_ground, scene.lidar.points);
  return {make_vision_maps(scene.vision.points, vision_h, 1.0, 1.0, options),
          make_vision_maps(scene.vision.points, vision_h, 0.5, 0.6, options),
          make_lidar_maps(scene.lidar.points, lidar_h, options)};
}

TEST(SearchOutlines, FindsAPlantedPoseWithUnknownHeading) {
  const SmallBlock block = small_block(3);
  PlanarPattern pattern = make_pattern(block.lidar, Eigen::Matrix3d::Identity());
  const double planted = 2.0;
  const Eigen::Rotation2D<double> turn(-planted);
  for (auto& facade : pattern.facades) {
    facade.point = turn * facade.point;
    facade.outward = turn * facade.outward;
  }
  for (auto& point : pattern.free_points) point = turn * point;
  const OutlineOptions options;
  const auto search = search_outlines(
      block.coarse, pattern, {.max_yaw_rad = std::numbers::pi}, options, RunContext{});
  ASSERT_TRUE(search) << search.error().message;
  const std::vector<PlanarPose>& peaks = search->peaks;
  ASSERT_GE(peaks.size(), 2U);
  const PlanarPose best = refine_pose(block.fine, pattern, peaks.front(), 1.0, options);
  // The pattern's centre did not move: the true position is the centre itself.
  EXPECT_LT((best.position - pattern.centre).norm(), 0.5);
  EXPECT_NEAR(std::remainder(best.yaw_rad - planted, 2.0 * std::numbers::pi), 0.0, 0.02);
  EXPECT_LT(peaks.at(1).score, 0.8 * peaks.front().score);
  const YawScore& top =
      *std::ranges::max_element(search->yaw_scores, {}, [](const YawScore& y) { return y.score; });
  EXPECT_EQ(top.yaw_rad, peaks.front().yaw_rad);
  EXPECT_EQ(top.score, peaks.front().score);
}

TEST(SearchOutlines, AgreesWithDirectLookUp) {
  const SmallBlock block = small_block(4);
  const PlanarPattern pattern = make_pattern(block.lidar, Eigen::Matrix3d::Identity());
  const OutlineOptions options;
  const auto search = search_outlines(block.coarse, pattern, {}, options, RunContext{});
  ASSERT_TRUE(search) << search.error().message;
  for (const PlanarPose& peak : search->peaks) {
    // Splatting the pattern and sampling the map are the same sum; FFT in single precision.
    EXPECT_NEAR(peak.score,
                score_of(block.coarse, pattern, peak, options.free_penalty),
                1e-3 * static_cast<double>(pattern.facades.size()));
  }
}

TEST(SearchOutlines, StaysInsideItsWindow) {
  const SmallBlock block = small_block(5);
  const PlanarPattern pattern = make_pattern(block.lidar, Eigen::Matrix3d::Identity());
  const Eigen::Vector2d away = pattern.centre + Eigen::Vector2d(15.0, 0.0);
  const auto search =
      search_outlines(block.coarse,
                      pattern,
                      {.yaw_rad = 0.5, .max_yaw_rad = 0.1, .position = away, .max_offset_m = 4.0},
                      OutlineOptions{},
                      RunContext{});
  ASSERT_TRUE(search) << search.error().message;
  for (const PlanarPose& peak : search->peaks) {
    EXPECT_LE((peak.position - away).norm(), 4.0);
    EXPECT_NEAR(peak.yaw_rad, 0.5, 0.12);  // whole steps may round the range up
  }
}

TEST(SearchOutlines, WithoutFacadesIsRefused) {
  const SmallBlock block = small_block(6);
  const auto search =
      search_outlines(block.coarse, PlanarPattern{}, {}, OutlineOptions{}, RunContext{});
  EXPECT_EQ(search.error().code, ErrorCode::kInsufficient);
}

TEST(MakeLidarMaps, OrientsFacadesToTheStreet) {
  std::vector<Eigen::Vector3f> points;
  for (float y = -10.0F; y < 10.0F; y += 0.1F) {
    for (float h = 0.0F; h < 8.0F; h += 0.25F) points.emplace_back(5.2F, y, h);
    for (float x = -5.0F; x < 5.0F; x += 0.2F) points.emplace_back(x, y, 0.0F);
  }
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : points) heights.push_back(p.z());
  const LidarMaps maps = make_lidar_maps(points, heights, OutlineOptions{});
  ASSERT_GT(maps.facades.size(), 30U);
  for (const FacadeCell& facade : maps.facades) EXPECT_LT(facade.outward.x(), -0.9);
  EXPECT_GT(maps.linear_share, 0.95);
}

TEST(AlignGround, FindsHeightRollAndPitch) {
  const SmallBlock block = small_block(7);
  Rigid3 wrong;
  wrong.rotation = Eigen::AngleAxisd(0.03, Eigen::Vector3d(1.0, 0.5, 0.0).normalized());
  wrong.translation.z() = 5.0;
  const auto aligned = align_ground(block.fine, block.lidar, wrong, 50);
  ASSERT_TRUE(aligned) << aligned.error().message;
  EXPECT_NEAR(aligned->vision_from_lidar.translation.z(), 0.0, 0.03);
  EXPECT_LT(
      rotation_distance_rad(aligned->vision_from_lidar.rotation, Eigen::Quaterniond::Identity()),
      0.002);
  EXPECT_EQ(align_ground(block.fine, LidarMaps{}, wrong, 50).error().code,
            ErrorCode::kInsufficient);
}

TEST(SplitHeading, GivesBackTheRotation) {
  const Rigid3 pose = test::random_motion(1, 10.0, 3.0);
  const auto [yaw_rad, tilt] = split_heading(pose.rotation);
  const Eigen::Matrix3d again = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * tilt;
  EXPECT_TRUE(again.isApprox(pose.rotation.toRotationMatrix(), 1e-12));
  EXPECT_GT(tilt(2, 2), 0.99);
}

}  // namespace
}  // namespace hybridfusion
