#include "street_scene.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

test::SceneOptions small_scene() {
  return {.half_extent_m = 38.0, .lidar_half_extent_m = 45.0};
}

double error_at_centroid(const Rigid3& truth, const Rigid3& estimate, const PointCloud& lidar) {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : lidar.points) {
    centroid += p.cast<double>() / static_cast<double>(lidar.size());
  }
  return (truth * centroid - estimate * centroid).norm();
}

TEST(RegisterCrossSource, RecoversThePoseWithUnknownHeadingAndNoInitial) {
  const test::Scene scene = test::make_scene(21, small_scene());
  const Rigid3 motion = test::random_motion(21, 40.0, std::numbers::pi);
  const PointCloud lidar = transformed(motion, scene.lidar);
  const auto result =
      register_cross_source(scene.vision, lidar, {}, {.max_yaw_rad = std::numbers::pi});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kOk) << result->reason;
  EXPECT_GT(result->confidence, 0.8);
  EXPECT_LT(error_at_centroid(motion.inverse(), result->vision_from_lidar, lidar), 0.05);
  EXPECT_LT(rotation_distance_rad(motion.inverse().rotation, result->vision_from_lidar.rotation),
            0.1 * kDeg);
  EXPECT_GE(result->candidates.size(), 1U);
  EXPECT_TRUE(result->score("peak_ratio"));
  EXPECT_FALSE(result->score("no such score"));
}

TEST(RegisterCrossSource, CorrectsACoarsePoseAndItsHeight) {
  const test::Scene scene = test::make_scene(22, small_scene());
  RegistrationInput input{.sensor_positions = scene.sensor_positions};
  Rigid3 coarse;
  coarse.rotation = Eigen::AngleAxisd(8.0 * kDeg, Eigen::Vector3d(0.1, 0.1, 1.0).normalized());
  coarse.translation = {6.0, -5.0, 7.0};
  input.vision_from_lidar_initial = coarse;
  const auto result = register_cross_source(scene.vision, scene.lidar, input);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kOk) << result->reason;
  EXPECT_LT(error_at_centroid(Rigid3{}, result->vision_from_lidar, scene.lidar), 0.05);
}

TEST(RegisterCrossSource, FollowsAMotionOfTheLidarCloud) {
  const test::Scene scene = test::make_scene(23, small_scene());
  const Rigid3 motion = test::random_motion(5, 10.0, 0.3);
  const auto still = register_cross_source(scene.vision, scene.lidar);
  const PointCloud moved = transformed(motion, scene.lidar);
  const auto after = register_cross_source(scene.vision, moved);
  ASSERT_TRUE(still && after);
  // Other voxels, hence not equal: within the accuracy of the fine stage.
  EXPECT_LT(error_at_centroid(
                still->vision_from_lidar * motion.inverse(), after->vision_from_lidar, moved),
            0.02);
}

TEST(RegisterCrossSource, IsTheSameAtAnyThreadCount) {
  const test::Scene scene = test::make_scene(24, small_scene());
  RunContext one;
  one.num_threads = 1;
  RunContext two;
  two.num_threads = 2;
  const auto a = register_cross_source(scene.vision, scene.lidar, {}, {}, one);
  const auto b = register_cross_source(scene.vision, scene.lidar, {}, {}, two);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->vision_from_lidar.translation, b->vision_from_lidar.translation);
  EXPECT_EQ(a->vision_from_lidar.rotation.coeffs(), b->vision_from_lidar.rotation.coeffs());
  EXPECT_EQ(a->covariance, b->covariance);
  EXPECT_EQ(a->confidence, b->confidence);
}

TEST(RegisterCrossSource, ReportsTheScaleOfTheVisionCloud) {
  const test::Scene scene = test::make_scene(25, small_scene());
  const auto result =
      register_cross_source(transformed(Sim3{.scale = 1.004}, scene.vision), scene.lidar);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_TRUE(result->vision_scale_supported) << result->vision_scale_sigma;
  EXPECT_NEAR(result->vision_scale, 1.0 / 1.004, 5e-4);
  // After the caller's rescaling the clouds coincide again.
  EXPECT_LT(error_at_centroid(Rigid3{}, rescaled_vision_from_lidar(*result), scene.lidar), 0.05);
}

TEST(RegisterCrossSource, RefusesAnotherSite) {
  const test::Scene here = test::make_scene(31, small_scene());
  for (const std::uint64_t seed : {32U, 33U}) {
    const test::Scene elsewhere = test::make_scene(seed, small_scene());
    const auto result =
        register_cross_source(here.vision, elsewhere.lidar, {}, {.max_yaw_rad = std::numbers::pi});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->status, RegistrationStatus::kRefused);
    EXPECT_LT(result->confidence, VerdictOptions{}.min_confidence);
    EXPECT_FALSE(result->reason.empty());
  }
}

TEST(RegisterCrossSource, RefusesAMirroredCloud) {
  test::Scene scene = test::make_scene(34, small_scene());
  for (Eigen::Vector3f& p : scene.lidar.points) p.x() = -p.x();
  const auto result =
      register_cross_source(scene.vision, scene.lidar, {}, {.max_yaw_rad = std::numbers::pi});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kRefused);
}

TEST(RegisterCrossSource, RefusesAFlatFieldTreesAloneAndAStraightCanyon) {
  test::SceneOptions options = small_scene();
  options.buildings = 0;
  options.trees = 0;
  const test::Scene flat = test::make_scene(35, options);
  options.trees = 25;
  const test::Scene trees = test::make_scene(36, options);
  options.is_straight_canyon = true;
  options.slope = 0.0;
  const test::Scene canyon = test::make_scene(37, options);
  for (const test::Scene& scene : {flat, trees, canyon}) {
    const auto result = register_cross_source(scene.vision, scene.lidar);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->status, RegistrationStatus::kRefused);
  }
}

TEST(RegisterCrossSource, RefusesTreesAloneBeforeAnySearch) {
  test::SceneOptions options = small_scene();
  options.buildings = 0;
  options.trees = 25;
  const test::Scene scene = test::make_scene(36, options);
  const auto result = register_cross_source(scene.vision, scene.lidar);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NE(result->reason.find("trees alone"), std::string::npos) << result->reason;
  EXPECT_TRUE(result->candidates.empty());
}

TEST(RegisterCrossSource, RefusesTwinPlacesUnlessThePriorDecides) {
  const test::Scene scene = test::make_scene(42, small_scene());
  Rigid3 beside;
  beside.translation = {80.0, 0.0, 0.0};
  const PointCloud twins = concatenate(scene.vision, transformed(beside, scene.vision));
  const auto blind = register_cross_source(twins, scene.lidar);
  ASSERT_TRUE(blind) << blind.error().message;
  EXPECT_EQ(blind->status, RegistrationStatus::kRefused);
  RegistrationInput input;
  input.vision_from_lidar_initial = Rigid3{.translation = {81.0, 1.0, 2.0}};
  Eigen::Matrix<double, 6, 1> sigma;
  sigma << 2.0, 2.0, 4.0, 0.05, 0.05, 0.05;
  input.initial_covariance = sigma.array().square().matrix().asDiagonal();
  const auto told = register_cross_source(twins, scene.lidar, input, {.max_offset_m = 200.0});
  ASSERT_TRUE(told) << told.error().message;
  EXPECT_EQ(told->status, RegistrationStatus::kOk) << told->reason;
  EXPECT_EQ(told->score("prior_decided"), 1.0);
  EXPECT_LT(error_at_centroid(beside, told->vision_from_lidar, scene.lidar), 0.05);
}

TEST(RegisterCrossSource, RefusesUnusableInputWithAnError) {
  PointCloud empty;
  PointCloud few;
  few.points.assign(10, Eigen::Vector3f::Zero());
  PointCloud broken;
  broken.points.assign(5000, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const test::Scene scene = test::make_scene(38, {.half_extent_m = 15.0});
  for (const PointCloud* cloud : {&empty, &few, &broken}) {
    EXPECT_EQ(register_cross_source(scene.vision, *cloud).error().code, ErrorCode::kInsufficient);
    EXPECT_EQ(register_cross_source(*cloud, scene.vision).error().code, ErrorCode::kInsufficient);
  }
  EXPECT_EQ(register_cross_source(scene.vision, scene.lidar, {}, {.method = "magic"}).error().code,
            ErrorCode::kInvalidOptions);
}

TEST(RegisterCrossSource, StopsWhenAsked) {
  const test::Scene scene = test::make_scene(39, {.half_extent_m = 20.0});
  std::stop_source source;
  source.request_stop();
  RunContext ctx;
  ctx.stop = source.get_token();
  EXPECT_EQ(register_cross_source(scene.vision, scene.lidar, {}, {}, ctx).error().code,
            ErrorCode::kCancelled);
}

TEST(RegisterCrossSource, NdtBaselineCorrectsASmallError) {
  const test::Scene scene = test::make_scene(40, small_scene());
  RegistrationInput input;
  input.vision_from_lidar_initial = Rigid3{.translation = {0.4, -0.3, 3.0}};
  const auto result = register_cross_source(scene.vision, scene.lidar, input, {.method = "ndt"});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->method, "ndt");
  EXPECT_LT(error_at_centroid(Rigid3{}, result->vision_from_lidar, scene.lidar), 0.3);
}

TEST(RegisterCrossSource, GicpBaselineRunsFromTheHeightAlignedStart) {
  test::Scene scene = test::make_scene(41, {.half_extent_m = 20.0, .lidar_half_extent_m = 20.0});
  RegistrationInput input;
  input.vision_from_lidar_initial = Rigid3{.translation = {0.2, -0.2, 4.0}};
  const auto result =
      register_cross_source(scene.vision, scene.lidar, input, {.method = "gicp", .voxel_m = 0.5});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->method, "gicp");
  EXPECT_LT(error_at_centroid(Rigid3{}, result->vision_from_lidar, scene.lidar), 0.5);
}

/// x y z of a binary little-endian PLY whose vertices are three floats.
PointCloud read_xyz(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::size_t count = 0;
  while (std::getline(file, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first;
    std::string second;
    if (words >> first >> second && first == "element" && second == "vertex") words >> count;
  }
  PointCloud cloud;
  cloud.points.resize(count);
  for (Eigen::Vector3f& p : cloud.points) {
    file.read(reinterpret_cast<char*>(p.data()), 3 * sizeof(float));
  }
  return cloud;
}

Rigid3 read_truth(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const std::string key = "\"vision_from_lidar\": [";
  std::string numbers = text.str().substr(text.str().find(key) + key.size());
  std::ranges::replace(numbers, ',', ' ');
  std::istringstream in(numbers);
  Eigen::Matrix4d matrix;
  for (int k = 0; k < 16; ++k) in >> matrix(k / 4, k % 4);
  return Rigid3::from_matrix(matrix);
}

TEST(RegisterCrossSourceOnPairs, IsRightWithUnknownHeadingAndRefusesAnotherPlace) {
  const char* data = std::getenv("HYBRIDFUSION_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "HYBRIDFUSION_TEST_DATA names no folder of recordings";
  const std::string pairs = std::string(data) + "/pairs/";
  const RegistrationOptions options{.max_yaw_rad = std::numbers::pi};
  for (const auto& [name, limit_m] :
       {std::pair{"pair-21", 0.015}, {"pair-22", 0.015}, {"pair-23", 0.15}, {"pair-24", 0.015}}) {
    const PointCloud vision = read_xyz(pairs + name + "/G.ply");
    const PointCloud lidar = read_xyz(pairs + name + "/L.ply");
    const auto result = register_cross_source(vision, lidar, {}, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->status, RegistrationStatus::kOk) << name << ": " << result->reason;
    const Rigid3 truth = read_truth(pairs + name + "/truth.json");
    EXPECT_LT(error_at_centroid(truth, result->vision_from_lidar, lidar), limit_m) << name;
  }
  const auto wrong = register_cross_source(
      read_xyz(pairs + "pair-21/G.ply"), read_xyz(pairs + "pair-22/L.ply"), {}, options);
  ASSERT_TRUE(wrong) << wrong.error().message;
  EXPECT_EQ(wrong->status, RegistrationStatus::kRefused);
}

}  // namespace
}  // namespace hybridfusion
