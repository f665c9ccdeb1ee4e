#include "place_support.hpp"

#include "street_scene.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

/// A crop of L on a block whose photos show most of the facades.
PreparedClouds crop(std::uint64_t seed) {
  test::Scene scene = test::make_scene(
      seed, {.half_extent_m = 40.0, .lidar_half_extent_m = 44.0, .trees = 6, .facade_share = 0.8});
  std::erase_if(scene.lidar.points,
                [](const Eigen::Vector3f& p) { return p.head<2>().norm() > 24.0F; });
  auto clouds = prepare_clouds(scene.vision, scene.lidar, {}, {}, RunContext{});
  EXPECT_TRUE(clouds) << clouds.error().message;
  return std::move(*clouds);
}

Rigid3 aside(double shift_m, double turn_rad = 0.0) {
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ())),
          .translation = {shift_m, -0.5 * shift_m, 0.0}};
}

OutlinePlace place_at(const Rigid3& pose, double score) {
  return {.planar = {.position = pose.translation.head<2>(), .score = score},
          .vision_from_leveled = pose,
          .score = score};
}

FineInputs inputs_at(const PreparedClouds& clouds, const Rigid3& pose) {
  return make_fine_inputs(clouds.vision, clouds.lidar, pose, {}, RunContext{});
}

TEST(FacadeSupport, IsLargeAtTheTruthAndSmallAside) {
  const PreparedClouds clouds = crop(5);
  FineInputs inputs = inputs_at(clouds, {});
  const double truth = facade_support(inputs, clouds, {}, {}, RunContext{});
  EXPECT_GT(truth, 0.65);
  EXPECT_LT(facade_support(inputs, clouds, aside(0.4), {}, RunContext{}), 0.3 * truth);
  EXPECT_LT(facade_support(inputs, clouds, aside(8.0), {}, RunContext{}), 0.3 * truth);
  EXPECT_EQ(facade_support(inputs, clouds, aside(500.0), {}, RunContext{}), 0.0);
}

TEST(FacadeSupport, IsTheSameAtAnyThreadCount) {
  const PreparedClouds clouds = crop(6);
  FineInputs one = inputs_at(clouds, {});
  FineInputs two = inputs_at(clouds, {});
  EXPECT_EQ(facade_support(one, clouds, aside(0.05), {}, RunContext{.num_threads = 1}),
            facade_support(two, clouds, aside(0.05), {}, RunContext{.num_threads = 3}));
}

TEST(FacadeSupport, FacadesBeyondTheVisionCloudHaveNone) {
  PreparedClouds clouds = crop(7);
  FineInputs whole = inputs_at(clouds, {});
  const double all = facade_support(whole, clouds, {}, {}, RunContext{});
  const std::vector<Eigen::Vector3f> vision = clouds.vision;
  double sum = 0.0;
  for (const float side : {-1.0F, 1.0F}) {
    std::vector<Eigen::Vector3f> half;
    for (const Eigen::Vector3f& p : vision) {
      if (side * p.x() > 0.0F) half.push_back(p);
    }
    ASSERT_TRUE(prepare_vision(std::move(half), {}, RunContext{}, clouds));
    FineInputs inputs = inputs_at(clouds, {});
    const double share = facade_support(inputs, clouds, {}, {}, RunContext{});
    EXPECT_LT(share, 0.9 * all);
    sum += share;
  }
  EXPECT_NEAR(sum, all, 0.15);
}

TEST(ChooseBySurfaces, TakesThePlaceWhoseFacadesAreThereNotTheOneThatScoresMore) {
  const PreparedClouds clouds = crop(4);
  const OutlinePlaces found{.places = {place_at(aside(9.0, 20.0 * kDeg), 100.0),
                                       place_at(aside(0.3, 0.5 * kDeg), 97.0),
                                       place_at(aside(-7.0), 90.0)}};
  FineInputs inputs = inputs_at(clouds, found.places.front().vision_from_leveled);
  const auto choice = choose_by_surfaces(inputs, clouds, found, {}, RunContext{});
  ASSERT_TRUE(choice) << choice.error().message;
  EXPECT_TRUE(choice->is_compared);
  EXPECT_EQ(choice->place, 1U);
  EXPECT_GT(choice->support, 0.65);
  EXPECT_LT(choice->rival_support, 0.7 * choice->support);
}

TEST(ChooseBySurfaces, WithoutSupportTheFirstPlaceStays) {
  const PreparedClouds clouds = crop(5);
  const OutlinePlaces found{
      .places = {place_at(aside(9.0, 20.0 * kDeg), 100.0), place_at(aside(-7.0), 90.0)}};
  FineInputs inputs = inputs_at(clouds, found.places.front().vision_from_leveled);
  const auto choice = choose_by_surfaces(inputs, clouds, found, {}, RunContext{});
  ASSERT_TRUE(choice) << choice.error().message;
  EXPECT_EQ(choice->place, 0U);
  EXPECT_LT(choice->support, VerdictOptions{}.min_facade_support);
}

TEST(ChooseBySurfaces, PlacesFromWhichTheSurfacesLeadToOnePoseAreNoRivals) {
  const PreparedClouds clouds = crop(5);
  const OutlinePlaces found{.places = {place_at(aside(0.3), 100.0), place_at(aside(-0.3), 95.0)}};
  FineInputs inputs = inputs_at(clouds, {});
  const auto choice = choose_by_surfaces(inputs, clouds, found, {}, RunContext{});
  ASSERT_TRUE(choice) << choice.error().message;
  EXPECT_EQ(choice->rival_support, 0.0);
}

TEST(ChooseBySurfaces, ComparesNothingWhereOnePlaceStandsOutOrNotAllAreInReach) {
  const PreparedClouds clouds = crop(5);
  FineInputs inputs = inputs_at(clouds, {});
  OutlinePlaces found{.places = {place_at({}, 100.0), place_at(aside(9.0), 60.0)}};
  EXPECT_FALSE(choose_by_surfaces(inputs, clouds, found, {}, RunContext{})->is_compared);
  found.places[1].score = 99.0;
  found.is_vision_whole = false;
  EXPECT_FALSE(choose_by_surfaces(inputs, clouds, found, {}, RunContext{})->is_compared);
}

TEST(ChooseBySurfaces, StopsWhenAsked) {
  const PreparedClouds clouds = crop(5);
  FineInputs inputs = inputs_at(clouds, {});
  const OutlinePlaces found{.places = {place_at({}, 100.0), place_at(aside(9.0), 99.0)}};
  std::stop_source source;
  source.request_stop();
  const auto choice =
      choose_by_surfaces(inputs, clouds, found, {}, RunContext{.stop = source.get_token()});
  ASSERT_FALSE(choice);
  EXPECT_EQ(choice.error().code, ErrorCode::kCancelled);
}

/// A vision cloud and, 90 m beside it, one of the same roofs.
struct Twins {
  test::Scene scene = {};
  PointCloud vision = {};
};

test::SceneOptions twin_scene(double facade_share) {
  return {.half_extent_m = 38.0, .lidar_half_extent_m = 38.0, .facade_share = facade_share};
}

Twins with_twin(std::uint64_t seed, PointCloud twin) {
  Twins twins{.scene = test::make_scene(seed, twin_scene(0.8))};
  const Rigid3 beside{.translation = {90.0, 0.0, 0.0}};
  twins.vision = concatenate(twins.scene.vision, transformed(beside, std::move(twin)));
  return twins;
}

TEST(RegisterCrossSource, FacadesDecideBetweenPlacesWhoseRoofsAreAlike) {
  // Every storey of the twin stands half a metre beside the one below.
  PointCloud staggered = test::make_scene(51, twin_scene(0.8)).vision;
  for (Eigen::Vector3f& p : staggered.points) {
    const int storey = static_cast<int>(std::floor((p.z() + 100.0F) / 1.5F)) % 3;
    p.head<2>() += 0.5F * static_cast<float>(storey - 1) * Eigen::Vector2f::Ones();
  }
  const Twins twins = with_twin(51, std::move(staggered));
  const auto result = register_cross_source(twins.vision, twins.scene.lidar);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_GT(result->score("peak_ratio"), VerdictOptions{}.max_peak_ratio);
  EXPECT_EQ(result->score("surfaces_compared"), 1.0);
  EXPECT_EQ(result->status, RegistrationStatus::kOk) << result->reason;
  EXPECT_LT(result->vision_from_lidar.translation.norm(), 0.1);
}

TEST(RegisterCrossSource, FacadesDoNotDecideAgainstAPlaceOfWhichThePhotosShowNone) {
  const Twins twins = with_twin(51, test::make_scene(51, twin_scene(0.0)).vision);
  const auto result = register_cross_source(twins.vision, twins.scene.lidar);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->status, RegistrationStatus::kRefused);
  EXPECT_EQ(result->score("surfaces_compared"), 0.0);
  EXPECT_NE(result->reason.find("ambiguous"), std::string::npos) << result->reason;
}

}  // namespace
}  // namespace hybridfusion
