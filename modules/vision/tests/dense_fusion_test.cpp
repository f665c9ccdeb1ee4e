#include "dense/depth_consistency.hpp"
#include "dense/depth_fusion.hpp"
#include "dense/depth_map.hpp"
#include "dense_scene.hpp"

#include <hybridfusion/vision/densify.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::DenseScene;
using testing::make_dense_scene;

/// The true depth map of a view of the scene, as stereo would deliver it.
DepthMap true_depth_map(const DenseScene& scene, std::uint32_t view) {
  CameraIntrinsics camera = scene.reconstruction.cameras.front();
  camera.k1 = 0.0;
  DepthMap map;
  map.view = view;
  map.grid = undistorted_grid(camera);
  map.enu_from_camera = *scene.reconstruction.views[view].enu_from_camera;
  map.depth_m = {camera.width_px, camera.height_px};
  map.sigma_m = {camera.width_px, camera.height_px, 0.05F};
  map.num_pairs = {camera.width_px, camera.height_px, 1};
  map.mask = {camera.width_px, camera.height_px, 255};
  map.rgb = {camera.width_px, camera.height_px};
  const Image8 image = testing::render(camera, map.enu_from_camera);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Eigen::Vector3d ray = ray_of(map.grid, {x, y});
      const Eigen::Vector3d p =
          testing::hit(map.enu_from_camera.translation, map.enu_from_camera.rotation * ray);
      map.depth_m.at(x, y) = static_cast<float>((map.enu_from_camera.inverse() * p).z());
      const std::uint8_t grey = image.pixels[3 * map.depth_m.offset(x, y)];
      map.rgb.at(x, y) = {grey, grey, grey};
    }
  }
  map.grey = grey_plane(map.rgb);
  return map;
}

std::vector<DepthMap> true_depth_maps(const DenseScene& scene) {
  std::vector<DepthMap> maps;
  for (std::uint32_t v = 0; v < 4; ++v) {
    maps.push_back(true_depth_map(scene, v));
    for (std::uint32_t o = 0; o < 4; ++o) {
      if (o != v) maps.back().overlapping.push_back(o);
    }
  }
  return maps;
}

TEST(MergeGuesses, AveragesTheAgreeingOnesByInverseVariance) {
  const DepthGuess merged = merge_guesses({{10.0, 0.1}, {10.1, 0.2}, {14.0, 0.1}});
  EXPECT_NEAR(merged.depth_m, (10.0 * 100 + 10.1 * 25) / 125, 1e-12);
  EXPECT_NEAR(merged.sigma_m, std::sqrt(1.0 / 125), 1e-12);
}

TEST(ErodeDepthEdges, DropsBothSidesOfAStepAndNothingElse) {
  DepthMap map;
  map.depth_m = {20, 5, 40.0F};
  for (int y = 0; y < 5; ++y) {
    for (int x = 10; x < 20; ++x) map.depth_m.at(x, y) = 36.0F;
  }
  erode_depth_edges(map, 0.02, 2);
  EXPECT_TRUE(map.has_depth(7, 2));
  EXPECT_FALSE(map.has_depth(8, 2));
  EXPECT_FALSE(map.has_depth(11, 2));
  EXPECT_TRUE(map.has_depth(12, 2));
}

TEST(DepthAt, InterpolatesOneSurfaceButNotAcrossAStep) {
  DepthMap map;
  map.depth_m = {4, 2, 40.0F};
  map.depth_m.at(1, 0) = map.depth_m.at(1, 1) = 40.2F;
  map.depth_m.at(3, 0) = map.depth_m.at(3, 1) = 30.0F;
  EXPECT_NEAR(depth_at(map, 0.5F, 0.5F), 40.1, 1e-5);
  EXPECT_NEAR(depth_at(map, 2.9F, 0.4F), 30.0, 1e-5);
  EXPECT_TRUE(std::isnan(depth_at(map, -3.0F, 0.0F)));
}

TEST(CheckDepths, KeepsTheTruthAndDropsAPlantedOutlier) {
  const DenseScene scene = make_dense_scene();
  std::vector<DepthMap> maps = true_depth_maps(scene);
  const float truth = maps[0].depth_m.at(100, 100);
  maps[0].depth_m.at(60, 60) -= 2.0F;  // a speck in the air: the others look through it
  const CheckedDepth checked = testing::checked(maps, 0);
  EXPECT_TRUE(std::isnan(checked.depth_m.at(60, 60)));
  EXPECT_NEAR(checked.depth_m.at(100, 100), truth, 0.02);
  EXPECT_LT(checked.sigma_m.at(100, 100), 0.04F);  // 0.05 / sqrt(2) with one supporter
  const auto kept =
      std::ranges::count_if(checked.depth_m.values, [](float z) { return !std::isnan(z); });
  EXPECT_GT(kept, static_cast<std::ptrdiff_t>(checked.depth_m.values.size() / 2));
}

TEST(CheckDepths, ADepthThatOnlyOnePhotoHasIsDropped) {
  const DenseScene scene = make_dense_scene();
  std::vector<DepthMap> maps = true_depth_maps(scene);
  for (std::uint32_t v = 1; v < 4; ++v) std::ranges::fill(maps[v].depth_m.values, std::nanf(""));
  const CheckedDepth checked = testing::checked(maps, 0);
  EXPECT_TRUE(std::ranges::all_of(checked.depth_m.values, [](float z) { return std::isnan(z); }));
}

TEST(CheckDepths, DifferentLooksAreDropped) {
  const DenseScene scene = make_dense_scene();
  std::vector<DepthMap> maps = true_depth_maps(scene);
  for (std::uint32_t v = 1; v < 4; ++v) {
    for (std::uint8_t& g : maps[v].grey.values) g = static_cast<std::uint8_t>(255 - g);
  }
  const CheckedDepth checked = testing::checked(maps, 0, {.trusted_views = 1000});
  EXPECT_TRUE(std::ranges::all_of(checked.depth_m.values, [](float z) { return std::isnan(z); }));
}

TEST(FuseDepthMaps, WeighsByInverseVariance) {
  const DenseScene scene = make_dense_scene();
  std::vector<DepthMap> maps = {true_depth_map(scene, 0), true_depth_map(scene, 1)};
  for (float& z : maps[1].depth_m.values) z += 0.3F;  // a sheet 0.3 m below
  std::ranges::fill(maps[1].sigma_m.values, 0.5F);    // but a hundred times weaker
  const PointCloud cloud = testing::fused(maps, 1.0, 1);
  ASSERT_FALSE(cloud.empty());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.points[i];
    const bool seen_by_both =
        std::abs(p.x()) < 6 && std::abs(p.y() + 2) < 4 && p.z() < 2 && p.z() > -0.2;
    if (seen_by_both && std::hypot(p.x(), p.y()) > 5) {
      EXPECT_NEAR(p.z(), 0.0, 0.02);
    }
    EXPECT_GE(cloud.normals[i].z(), -1e-3F);  // towards the photos
  }
}

TEST(Densify, RecoversGroundAndRoofOfASyntheticBlock) {
  const DenseScene scene = make_dense_scene();
  const auto cloud = densify(scene.photos, scene.reconstruction, {});
  ASSERT_TRUE(cloud) << cloud.error().message;
  EXPECT_GT(cloud->size(), 2000U);
  EXPECT_EQ(cloud->colors.size(), cloud->size());
  std::vector<double> errors;
  std::size_t on_roof = 0;
  for (const Eigen::Vector3f& p : cloud->points) {
    const bool roof = std::abs(p.x()) < 2.5F && std::abs(p.y()) < 2.5F;
    if (!roof && std::abs(p.x()) < 4.0F && std::abs(p.y()) < 4.0F) continue;  // beside the walls
    on_roof += roof ? 1 : 0;
    errors.push_back(std::abs(p.z() - (roof ? testing::kRoof_m : 0.0)));
  }
  std::ranges::sort(errors);
  // One pixel of disparity is 40^2 / (400 * 8) = 0.5 m here; a tenth of it is asked for.
  EXPECT_LT(errors[errors.size() / 2], 0.05);
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.25);
  EXPECT_GT(on_roof, 200U);
}

TEST(Densify, GivesTheSameBytesAtAnyThreadCount) {
  const DenseScene scene = make_dense_scene();
  const auto one = densify(scene.photos, scene.reconstruction, {}, {.num_threads = 1});
  const auto three = densify(scene.photos, scene.reconstruction, {}, {.num_threads = 3});
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->points, three->points);
  EXPECT_EQ(one->colors, three->colors);
  EXPECT_EQ(one->sigmas_m, three->sigmas_m);
}

TEST(Densify, LittleMemoryAndAScratchFolderGiveTheSameBytes) {
  const DenseScene scene = make_dense_scene();
  const DensifyOptions little{.max_memory_mib = 0};  // below what the option table lets a user set
  const auto in_memory = densify(scene.photos, scene.reconstruction, {});
  const auto on_disk = densify(
      scene.photos, scene.reconstruction, little, {}, std::filesystem::temp_directory_path());
  ASSERT_TRUE(in_memory && on_disk);
  EXPECT_EQ(in_memory->points, on_disk->points);
  EXPECT_EQ(in_memory->normals, on_disk->normals);
  EXPECT_EQ(in_memory->sigmas_m, on_disk->sigmas_m);
}

TEST(Densify, OneRegisteredPhotoIsInsufficient) {
  DenseScene scene = make_dense_scene();
  for (std::size_t v = 1; v < 4; ++v) scene.reconstruction.views[v].enu_from_camera.reset();
  EXPECT_EQ(densify(scene.photos, scene.reconstruction, {}).error().code, ErrorCode::kInsufficient);
}

TEST(Densify, ADamagedPhotoIsLeftOutAndSaid) {
  DenseScene scene = make_dense_scene();
  scene.photos[3].load = [] { return Expected<Image8>(fail(ErrorCode::kParse, "truncated")); };
  std::vector<std::string> warnings;
  const RunContext ctx{.log = [&](LogLevel level, std::string_view message) {
    if (level == LogLevel::kWarning) warnings.emplace_back(message);
  }};
  EXPECT_TRUE(densify(scene.photos, scene.reconstruction, {}, ctx));
  EXPECT_TRUE(std::ranges::find(warnings, "truncated") != warnings.end());
}

}  // namespace
}  // namespace hybridfusion
