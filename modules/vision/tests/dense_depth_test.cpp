#include "dense/depth_consistency.hpp"
#include "dense/depth_fusion.hpp"
#include "dense/depth_map_store.hpp"
#include "dense/pair_choice.hpp"
#include "dense_box_scene.hpp"

#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const Eigen::Vector3d kDown(0.0, 0.0, -1.0);

TEST(MergeGuesses, WeighsByInverseVarianceAndLeavesOutWhatDisagrees) {
  const DepthGuess merged = merge_guesses({{10.0, 0.1}, {10.3, 0.2}, {25.0, 0.1}});
  EXPECT_NEAR(merged.depth_m, (10.0 * 100 + 10.3 * 25) / 125, 1e-12);
  EXPECT_NEAR(merged.sigma_m, 1.0 / std::sqrt(125.0), 1e-12);
}

TEST(MergeGuesses, OneGuessStaysAsItIs) {
  const DepthGuess merged = merge_guesses({{7.5, 0.25}});
  EXPECT_DOUBLE_EQ(merged.depth_m, 7.5);
  EXPECT_DOUBLE_EQ(merged.sigma_m, 0.25);
}

TEST(ErodeDepthEdges, DropsTheMarginAroundARoof) {
  DepthMap map;
  map.depth_m = {20, 10, 50.0F};
  for (int y = 0; y < 10; ++y) {
    for (int x = 10; x < 20; ++x) map.depth_m.at(x, y) = 40.0F;
  }
  erode_depth_edges(map, 0.02, 2);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(std::isnan(map.depth_m.at(x, y)), x >= 8 && x <= 11) << x << ", " << y;
    }
  }
}

TEST(DepthAt, InterpolatesOnASurfaceAndTakesTheNearestAtAnEdge) {
  DepthMap map;
  map.depth_m = {3, 2, 50.0F};
  map.depth_m.at(1, 0) = 50.1F;
  map.depth_m.at(1, 1) = 50.1F;
  map.depth_m.at(2, 0) = 30.0F;
  map.depth_m.at(2, 1) = kNone;
  EXPECT_NEAR(depth_at(map, 0.5F, 0.5F), 50.05, 1e-5);
  EXPECT_FLOAT_EQ(depth_at(map, 1.8F, 0.2F), 30.0F);
  EXPECT_TRUE(std::isnan(depth_at(map, 1.8F, 0.9F)));
  EXPECT_TRUE(std::isnan(depth_at(map, -3.0F, 0.0F)));
}

/// Four photos of the box scene with perfect depths; every photo overlaps every other.
struct FourPhotos {
  testing::BoxScene scene{.texture_m = 1.0};
  std::vector<DepthMap> maps;

  explicit FourPhotos(double sigma_m = 0.05, double size = 1.0) {
    const std::vector<Rigid3> poses{testing::looking({-5, 0, 40}, kDown, 0.0),
                                    testing::looking({5, 0, 40}, kDown, 3.0),
                                    testing::looking({0, 6, 41}, kDown, 1.5),
                                    testing::looking({0, -6, 39}, kDown, 0.2)};
    const auto camera =
        testing::small_camera(static_cast<int>(160 * size), static_cast<int>(120 * size));
    for (std::uint32_t v = 0; v < poses.size(); ++v) {
      maps.push_back(testing::perfect_depths(scene, {camera, poses[v]}, v, sigma_m));
      for (std::uint32_t other = 0; other < poses.size(); ++other) {
        if (other != v) maps.back().overlapping.push_back(other);
      }
      maps.back().partners = {(v + 1) % 4};
    }
  }
};

double count_depths(const ImagePlane<float>& plane) {
  return static_cast<double>(
      std::ranges::count_if(plane.values, [](float z) { return !std::isnan(z); }));
}

TEST(DepthConsistency, KeepsTrueDepthsAndReducesTheirSigma) {
  const FourPhotos photos;
  const CheckedDepth checked = testing::checked(photos.maps, 0);
  // A fifth of the photo is beyond the edge of all others.
  EXPECT_GT(count_depths(checked.depth_m), 0.75 * count_depths(photos.maps[0].depth_m));
  EXPECT_NEAR(checked.depth_m.at(45, 60), photos.maps[0].depth_m.at(45, 60), 0.03);
  EXPECT_LT(checked.sigma_m.at(80, 60), 0.05F);
}

TEST(DepthConsistency, DropsAPlantedOutlierInFrontOfAndBehindTheSurface) {
  FourPhotos photos;
  for (const float factor : {0.8F, 1.2F}) {
    const float truth = photos.maps[0].depth_m.at(40, 60);
    photos.maps[0].depth_m.at(40, 60) = factor * truth;
    const CheckedDepth checked = testing::checked(photos.maps, 0);
    EXPECT_TRUE(std::isnan(checked.depth_m.at(40, 60))) << factor;
    EXPECT_FALSE(std::isnan(checked.depth_m.at(50, 60)));
    photos.maps[0].depth_m.at(40, 60) = truth;
  }
}

TEST(DepthConsistency, APhotoWithoutSupportKeepsNothing) {
  FourPhotos photos;
  for (std::size_t v = 1; v < 4; ++v) {
    std::ranges::fill(photos.maps[v].depth_m.values, kNone);
  }
  EXPECT_EQ(count_depths(testing::checked(photos.maps, 0).depth_m), 0);
}

TEST(DepthConsistency, ASecondPairOfThePhotoConfirmsADepthAsWellAsAnotherMap) {
  FourPhotos photos;
  for (std::size_t v = 1; v < 4; ++v) {
    std::ranges::fill(photos.maps[v].depth_m.values, kNone);
  }
  std::ranges::fill(photos.maps[0].num_pairs.values, std::uint8_t{2});
  const auto before = count_depths(photos.maps[0].depth_m);
  EXPECT_GT(count_depths(testing::checked(photos.maps, 0).depth_m), 0.75 * before);
  EXPECT_EQ(count_depths(testing::checked(photos.maps, 0, {.min_supporting_views = 2}).depth_m), 0);
}

TEST(DepthConsistency, DropsDepthsWhereNoOtherPhotoLooksAlike) {
  FourPhotos photos;
  for (std::size_t v = 1; v < 4; ++v) {
    for (std::size_t i = 0; i < photos.maps[v].grey.values.size(); ++i) {
      const auto noise = static_cast<std::uint8_t>(
          255.0 * testing::lattice(static_cast<int>(i), static_cast<int>(v), 9));
      photos.maps[v].grey.values[i] = noise;
    }
  }
  const auto before = count_depths(photos.maps[0].depth_m);
  // Correlation of 25 independent pairs exceeds 0.5 with a probability of about 1 %, for each of
  // three judges.
  const DepthCheckOptions looks{.trusted_views = 1000};
  EXPECT_LT(count_depths(testing::checked(photos.maps, 0, looks).depth_m), 0.05 * before);
  EXPECT_GT(count_depths(testing::checked(photos.maps, 0).depth_m), 0.5 * before)
      << "two others that agree suffice";
  EXPECT_GT(count_depths(testing::checked(photos.maps, 0, {.min_correlation = -1.0}).depth_m),
            0.75 * before);
}

TEST(DepthConsistency, IsTheSameAtAnyNumberOfThreads) {
  // More rows than one thread takes at a time.
  const auto photos = FourPhotos(0.05, 3.0);
  const CheckedDepth one = testing::checked(photos.maps, 0, {}, {.num_threads = 1});
  const CheckedDepth four = testing::checked(photos.maps, 0, {}, {.num_threads = 4});
  ASSERT_GT(one.depth_m.height, 300);
  EXPECT_GT(count_depths(one.depth_m), 0.75 * count_depths(photos.maps[0].depth_m));
  const auto same = [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  EXPECT_TRUE(std::ranges::equal(one.depth_m.values, four.depth_m.values, same));
  EXPECT_EQ(one.sigma_m.values, four.sigma_m.values);
}

TEST(DepthConsistency, TwoSheetsBecomeOne) {
  FourPhotos photos;
  for (float& z : photos.maps[0].depth_m.values) z += 0.06F;
  for (std::size_t v = 1; v < 4; ++v) {
    for (float& z : photos.maps[v].depth_m.values) z -= 0.06F;
  }
  std::vector<float> heights;
  for (std::uint32_t v = 0; v < 4; ++v) {
    const CheckedDepth checked = testing::checked(photos.maps, v);
    const float z = checked.depth_m.at(45, 60);
    ASSERT_FALSE(std::isnan(z)) << v;
    heights.push_back(static_cast<float>(photos.maps[v].point_in_enu(20, 60, z).z()));
  }
  const auto [low, high] = std::ranges::minmax(heights);
  EXPECT_LT(high - low, 0.035F);  // were 0.12 m apart
}

TEST(DepthFusion, MergesTwoSheetsWithTheWeightsOfTheirSigmas) {
  const testing::BoxScene scene{.box_height_m = 0.0};
  const PosedCamera camera{testing::small_camera(80, 60), testing::looking({0, 0, 20}, kDown, 0)};
  std::vector<DepthMap> maps{testing::perfect_depths(scene, camera, 0, 0.02),
                             testing::perfect_depths(scene, camera, 1, 0.04)};
  // Heights 0.5 and 0.7 m: one voxel of 1 m. Mean = (0.5 * 4 + 0.7 * 1) / 5.
  for (float& z : maps[0].depth_m.values) z -= 0.5F;
  for (float& z : maps[1].depth_m.values) z -= 0.7F;
  const PointCloud cloud = testing::fused(maps, 1.0, 2);
  ASSERT_GT(cloud.size(), 100U);
  ASSERT_TRUE(validate(cloud));
  int inner = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.points[i].head<2>().norm() > 6.0F) continue;  // whole voxels only
    ++inner;
    EXPECT_NEAR(cloud.points[i].z(), 0.54F, 0.01F);
    EXPECT_GT(cloud.normals[i].z(), 0.99F);
    EXPECT_GE(cloud.confidences[i], 2.0F);
    EXPECT_GT(cloud.sigmas_m[i], 0.0F);
  }
  EXPECT_GT(inner, 50);
}

TEST(DepthFusion, DropsThinVoxelsAndTheFarField) {
  const testing::BoxScene scene{.box_height_m = 0.0};
  const PosedCamera camera{testing::small_camera(80, 60), testing::looking({0, 0, 20}, kDown, 0)};
  const std::vector<DepthMap> maps{testing::perfect_depths(scene, camera, 0, 0.02)};
  EXPECT_GT(testing::fused(maps, 1.0, 2).size(), 100U);
  EXPECT_EQ(testing::fused(maps, 0.01, 2).size(), 0U);  // one depth a voxel
}

TEST(DepthMap, FarDepthsAreDroppedAndNearOnesKept) {
  DepthMap map;
  map.depth_m = {3, 1, 50.0F};
  map.depth_m.at(1, 0) = 61.0F;
  map.depth_m.at(2, 0) = kNone;
  drop_far_depths(map, 60.0);
  EXPECT_EQ(map.depth_m.at(0, 0), 50.0F);
  EXPECT_TRUE(std::isnan(map.depth_m.at(1, 0)));
}

TEST(DepthMapStore, MapsOnDiskComeBackByteForByteWithinTheMemoryGiven) {
  const FourPhotos photos;
  constexpr std::size_t kBytes = 160 * 120 * 13;
  const auto store = DepthMapStore::create(5, 2 * kBytes, std::filesystem::temp_directory_path());
  ASSERT_TRUE(store);
  for (std::uint32_t v = 0; v < 4; ++v) ASSERT_TRUE((*store)->put(v, photos.maps[v]));
  for (const std::uint32_t v : {0U, 3U, 1U, 2U, 0U}) {
    const auto map = (*store)->get(v);
    ASSERT_TRUE(map && *map);
    const DepthMap& expected = photos.maps[v];
    EXPECT_EQ(std::memcmp((*map)->depth_m.values.data(),
                          expected.depth_m.values.data(),
                          expected.depth_m.values.size() * sizeof(float)),
              0);
    EXPECT_EQ((*map)->sigma_m.values, expected.sigma_m.values);
    EXPECT_EQ((*map)->rgb.values, expected.rgb.values);
    EXPECT_EQ((*map)->grey.values, expected.grey.values);
    EXPECT_EQ((*map)->mask.values, expected.mask.values);
    EXPECT_EQ((*map)->partners, expected.partners);
    EXPECT_EQ((*map)->overlapping, expected.overlapping);
    EXPECT_LE((*store)->resident_bytes(), 2 * kBytes);
  }
  const auto none = (*store)->get(4);
  ASSERT_TRUE(none);
  EXPECT_EQ(*none, nullptr);
}

TEST(DepthMapStore, AFolderThatDoesNotExistIsAnIoError) {
  const auto store = DepthMapStore::create(2, 1, "/nonexistent/folder");
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::kIo);
}

TEST(DepthFusion, RemovesASpeckInTheAir) {
  const testing::BoxScene scene{.box_height_m = 0.0};
  const PosedCamera camera{testing::small_camera(160, 120), testing::looking({0, 0, 20}, kDown, 0)};
  std::vector<DepthMap> maps{testing::perfect_depths(scene, camera, 0, 0.02)};
  for (const int x : {80, 81, 82}) {
    for (const int y : {60, 61, 62}) maps[0].depth_m.at(x, y) = 8.0F;
  }
  for (const Eigen::Vector3f& p : testing::fused(maps, 0.5, 2).points) {
    EXPECT_LT(p.z(), 1.0F);
  }
}

/// Views on a line and one beside it, all sharing the same points on the ground.
Reconstruction shared_ground(const std::vector<Eigen::Vector3d>& centres, int num_points) {
  Reconstruction r;
  r.cameras = {testing::small_camera()};
  for (const Eigen::Vector3d& c : centres) {
    r.views.push_back({.enu_from_camera = testing::looking(c, kDown, 0.0)});
  }
  for (int i = 0; i < num_points; ++i) {
    ScenePoint point{.point_in_enu = {0.01 * i, -0.01 * i, 0.0}};
    for (std::uint32_t v = 0; v < r.views.size(); ++v) {
      point.track.push_back({v, static_cast<std::uint32_t>(i)});
      r.views[v].observations.push_back({.point = static_cast<std::uint32_t>(i)});
    }
    r.points.push_back(point);
  }
  return r;
}

TEST(PairChoice, PrefersTheBestAngleThenAnotherDirection) {
  // Angles at 50 m: 10.5 m is 12 deg, 9.6 m is 11 deg, 0.5 m is 0.6 deg, 45 m is 42 deg.
  const Reconstruction r = shared_ground(
      {{0, 0, 50}, {10.5, 0, 50}, {9.6, 0, 50}, {0, 8.7, 50}, {0.5, 0, 50}, {45, 0, 50}}, 200);
  const auto partners = choose_partners(r, 0, {.num_neighbors = 2});
  ASSERT_EQ(partners.size(), 2U);
  EXPECT_EQ(partners[0].view, 1U);
  EXPECT_EQ(partners[1].view, 3U);
  EXPECT_NEAR(partners[0].median_angle_rad, std::atan(10.5 / 50.0), 0.02);
  EXPECT_EQ(partners[0].shared_points.size(), 200U);
  EXPECT_EQ(choose_partners(r, 0, {.num_neighbors = 10}).size(), 3U);
}

TEST(PairChoice, LeavesOutViewsThatShareLittleOrAreNotRegistered) {
  EXPECT_TRUE(choose_partners(shared_ground({{0, 0, 50}, {10, 0, 50}}, 20), 0, {}).empty());
  Reconstruction r = shared_ground({{0, 0, 50}, {10, 0, 50}}, 200);
  EXPECT_EQ(choose_partners(r, 0, {}).size(), 1U);
  r.views[1].enu_from_camera.reset();
  EXPECT_TRUE(choose_partners(r, 0, {}).empty());
}

}  // namespace
}  // namespace hybridfusion
