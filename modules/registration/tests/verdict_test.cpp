#include "verdict.hpp"

#include "baselines.hpp"
#include "street_scene.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

PreparedClouds prepared(std::uint64_t seed) {
  const test::Scene scene =
      test::make_scene(seed, {.half_extent_m = 30.0, .lidar_half_extent_m = 36.0, .trees = 6});
  auto clouds = prepare_clouds(scene.vision, scene.lidar, {}, {}, RunContext{});
  EXPECT_TRUE(clouds) << clouds.error().message;
  return std::move(*clouds);
}

TEST(JudgeSurfaces, AcceptsTheTruePoseAndRefusesThoseThreeMetresAside) {
  for (const std::uint64_t seed : {3, 4}) {
    const PreparedClouds clouds = prepared(seed);
    const SurfaceVerdict truth = judge_surfaces(baseline_evidence(clouds, {}), {});
    EXPECT_EQ(truth.reason, "");
    EXPECT_GT(truth.confidence, 0.9);
    for (int k = 0; k < 8; ++k) {
      const double bearing_rad = k * std::numbers::pi / 4.0;
      const Rigid3 aside{
          .translation = {3.0 * std::cos(bearing_rad), 3.0 * std::sin(bearing_rad), 0.0}};
      const SurfaceVerdict wrong = judge_surfaces(baseline_evidence(clouds, aside), {});
      EXPECT_NE(wrong.reason, "") << "seed " << seed << ", bearing " << k;
      EXPECT_LT(wrong.confidence, VerdictOptions{}.min_confidence);
    }
  }
}

TEST(JudgeSurfaces, NamesWhatSpeaksAgainstThePose) {
  const PoseEvidence good{.facade_share = 0.95, .ground_share = 1.0};
  EXPECT_EQ(judge_surfaces(good, {}).reason, "");
  EXPECT_EQ(judge_surfaces(good, {}).confidence, 1.0);
  PoseEvidence inside = good;
  inside.free_violations = 0.25;
  EXPECT_NE(judge_surfaces(inside, {}).reason.find("inside vision buildings"), std::string::npos);
  PoseEvidence above = good;
  above.ground_share = 0.4;
  EXPECT_NE(judge_surfaces(above, {}).reason.find("within 0.2 m of the vision ground"),
            std::string::npos);
}

Evidence good_evidence() {
  return {.best_score = 100.0,
          .second_score = 30.0,
          .best = {.facade_weight_on_edges = 500.0, .facade_share = 0.95, .ground_share = 1.0},
          .ground_inliers = 1000,
          .linear_share = 0.5,
          .has_fine = true,
          .fine_agrees = true,
          .patches_tried = 20,
          .patch_share = 1.0};
}

RegistrationResult verdict_on(const Evidence& evidence) {
  RegistrationResult result;
  pronounce(evidence, {}, result);
  return result;
}

TEST(Pronounce, BelievesAPlaceAmongEqualsWhoseSurfacesAloneFit) {
  Evidence e = good_evidence();
  e.second_score = 97.0;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
  e.surfaces_compared = true;
  e.facade_support = 0.8;
  e.rival_support = 0.4;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kOk) << verdict_on(e).reason;
  EXPECT_EQ(verdict_on(e).score("rival_facade_support"), 0.4);
  e.rival_support = 0.75;  // a twin
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
  EXPECT_NE(verdict_on(e).reason.find("ambiguous"), std::string::npos);
  e.facade_support = 0.6;  // better than the others, but not there
  e.rival_support = 0.1;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
  e.facade_support = 0.0;
  e.rival_support = 0.0;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
}

TEST(Pronounce, SurfacesThatDecideNothingTakeNothingFromAPlaceThatStandsOut) {
  Evidence e = good_evidence();
  e.surfaces_compared = true;
  e.facade_support = 0.1;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kOk);
  EXPECT_EQ(verdict_on(e).confidence, 1.0);
}

TEST(Pronounce, RefusesADoubtfulPlaceWhoseFacadesLieOnNoSurface) {
  Evidence e = good_evidence();
  e.second_score = 0.79 * e.best_score;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kOk) << verdict_on(e).reason;
  e.surfaces_compared = true;  // the photos show facades there
  e.facade_support = 0.004;
  e.rival_support = 0.001;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
  EXPECT_NE(verdict_on(e).reason.find("ambiguous"), std::string::npos);
}

TEST(Pronounce, DoubtsAPoseOfWhichNoPatchKnows) {
  Evidence e = good_evidence();
  e.has_fine = true;
  e.patches_tried = 3;  // too few for a vote
  EXPECT_EQ(verdict_on(e).confidence, 1.0);
  e.patches_tried = 0;
  EXPECT_LT(verdict_on(e).confidence, 0.9);
  e.second_score = 0.79 * e.best_score;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
}

TEST(Pronounce, BelievesSurfacesThatLeadAsideOnlyWhereFacadesAreSupported) {
  Evidence e = good_evidence();
  e.fine_agrees = false;
  e.fine_stays = true;
  e.facade_support = 0.8;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kOk) << verdict_on(e).reason;
  e.facade_support = 0.6;
  EXPECT_EQ(verdict_on(e).status, RegistrationStatus::kRefused);
  EXPECT_NE(verdict_on(e).reason.find("lead away"), std::string::npos);
}

TEST(Pronounce, RefusesAPlaceFromWhichTheSurfacesLeadAway) {
  Evidence e = good_evidence();
  RegistrationResult result;
  pronounce(e, {}, result);
  EXPECT_EQ(result.status, RegistrationStatus::kOk) << result.reason;
  e.fine_agrees = false;
  pronounce(e, {}, result);
  EXPECT_EQ(result.status, RegistrationStatus::kRefused);
  EXPECT_NE(result.reason.find("lead away"), std::string::npos) << result.reason;
  e.has_fine = false;  // nothing to align, nothing that contradicts
  pronounce(e, {}, result);
  EXPECT_EQ(result.status, RegistrationStatus::kOk) << result.reason;
  EXPECT_LT(result.confidence, 0.7);
}

}  // namespace
}  // namespace hybridfusion
