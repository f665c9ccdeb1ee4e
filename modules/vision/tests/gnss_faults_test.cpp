/// @file
/// Faults of real receivers on a synthetic flight, from the placement to the verdict: scale and
/// tilt come through, or the verdict says that they did not.
#include "enu_alignment.hpp"
#include "flight_errors.hpp"
#include "georeference.hpp"
#include "gnss_adjustment.hpp"
#include "placement.hpp"
#include "rotation.hpp"
#include "synthetic_flight.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr double kDegree = M_PI / 180.0;

struct Case {
  testing::SyntheticFlight flight;
  GnssIngest gnss;
  std::vector<PhotoMetadata> photos;
};

GimbalAngles reading_of(const Eigen::Vector3d& up_in_camera) {
  // Written to a tenth of a degree.
  const auto rounded = [](double rad) { return std::round(10.0 * rad / kDegree) / 10.0; };
  return {.pitch_deg = rounded(std::asin(up_in_camera.z())),
          .roll_deg = rounded(std::atan2(-up_in_camera.x(), -up_in_camera.y()))};
}

/// Three strips of eight photos, 49 x 28 m, 2.5 s apart; RTK tags of 2 cm; the camera mount is off
/// by 0.7 degrees.
Case make_case(std::uint64_t seed, double jitter_m = 1.0) {
  Case c;
  c.flight = testing::make_flight({.columns = 8,
                                   .rows = 3,
                                   .num_points = 160,
                                   .spacing_m = 7.0,
                                   .tilt_rad = 0.05,
                                   .jitter_m = jitter_m,
                                   .seed = seed});
  Random random(seed, "test/tags");
  const Eigen::Quaterniond mount = rotation_exp({0.7 * kDegree, 0.2 * kDegree, 0.0});
  for (std::size_t v = 0; v < c.flight.time_s.size(); ++v) {
    const Rigid3& pose = *c.flight.truth.world_from_view[v];
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    c.gnss.fixes.push_back({.position_in_enu = pose.translation + 0.02 * noise,
                            .sigma_m = {0.02, 0.02, 0.03},
                            .has_altitude = true,
                            .is_rtk = true,
                            .flight_time_s = c.flight.time_s[v]});
    c.gnss.by_time.push_back(v);
    PhotoMetadata photo;
    photo.gimbal = reading_of(mount * (pose.rotation.conjugate() * Eigen::Vector3d::UnitZ()));
    c.photos.push_back(photo);
  }
  return c;
}

struct Outcome {
  double tilt_deg = 0.0;
  double scale_error = 0.0;
  double height_error_m = 0.0;
  ReconstructionQuality quality;
  Placement placement;
};

/// The truth in another frame and of another size, placed and adjusted.
Outcome reconstruct_case(const Case& c) {
  SfmModel model = c.flight.truth;
  transform_model(model,
                  {.rotation = Eigen::Quaterniond(
                       Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, 3).normalized())),
                   .translation = {5, 6, 7},
                   .scale = 0.11});
  Outcome outcome;
  const auto alignment = align_to_enu(model, c.gnss, c.photos, Random(1, "test"));
  EXPECT_TRUE(alignment);
  if (!alignment) return outcome;
  add_placement(*alignment, model, outcome.placement);
  transform_model(model, alignment->enu_from_world);
  const ReconstructionOptions options;
  GnssTerms terms = gnss_terms(model, c.gnss, options.gnss, outcome.placement);
  EXPECT_TRUE(adjust_with_gnss(model, terms, {}, options, {}));
  assess_georeference(model, terms, c.gnss, outcome.placement, outcome.quality);
  std::vector<Eigen::Vector3d> truth;
  std::vector<Eigen::Vector3d> found;
  for (const std::uint32_t view : model.registered()) {
    truth.push_back(c.flight.truth.world_from_view[view]->translation);
    found.push_back(model.world_from_view[view]->translation);
    outcome.height_error_m += (found.back() - truth.back()).z() / 24.0;
  }
  const Sim3 fit = fit_sim3(found, truth).value();
  outcome.scale_error = fit.scale - 1.0;
  outcome.tilt_deg =
      std::acos(std::min(1.0, (fit.rotation * Eigen::Vector3d::UnitZ()).z())) / kDegree;
  return outcome;
}

void expect_scale_and_tilt(const Outcome& outcome) {
  EXPECT_LT(outcome.tilt_deg, 0.5);
  EXPECT_LT(std::abs(outcome.scale_error), 0.005);
}

class GnssFaults : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(GnssFaults, NoneIsSeenInGoodTags) {
  const Outcome outcome = reconstruct_case(make_case(GetParam()));
  EXPECT_LT(outcome.tilt_deg, 0.1);
  EXPECT_LT(std::abs(outcome.scale_error), 0.001);
  EXPECT_FALSE(outcome.placement.errors.drift);
  EXPECT_FALSE(outcome.placement.errors.lag);
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kGood);
}

TEST_P(GnssFaults, WhiteNoiseOfThreeMetresIsReportedWhereItSpoilsTheScale) {
  Case c = make_case(GetParam());
  Random random(GetParam(), "test/white");
  for (PhotoFix& fix : c.gnss.fixes) {
    *fix.position_in_enu +=
        3.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  const Outcome outcome = reconstruct_case(c);
  EXPECT_LT(outcome.tilt_deg, 0.5);
  EXPECT_FALSE(outcome.placement.errors.drift);
  EXPECT_FALSE(outcome.placement.errors.lag);
  // 3 m over 24 photos within 49 x 28 m: 3 m / (19 m sqrt(24)) is 3 %.
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kUnusable);
  EXPECT_LT(std::abs(outcome.scale_error), 4.0 * outcome.quality.scale_sigma);
}

TEST_P(GnssFaults, DriftOfTheAltitudesIsTakenOut) {
  Case c = make_case(GetParam());
  for (PhotoFix& fix : c.gnss.fixes) {
    fix.position_in_enu->z() += 100.0 * fix.flight_time_s / 57.5;
  }
  const Outcome outcome = reconstruct_case(c);
  expect_scale_and_tilt(outcome);
  EXPECT_TRUE(outcome.placement.errors.drift);
  EXPECT_NEAR(outcome.quality.flights[0].rate_mps, 100.0 / 57.5, 0.05);
  EXPECT_LT(std::abs(outcome.height_error_m), 3.0);
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kLimited);
}

TEST_P(GnssFaults, BendingDriftIsNotTakenForATilt) {
  Case c = make_case(GetParam());
  for (PhotoFix& fix : c.gnss.fixes) {
    fix.position_in_enu->z() += 40.0 * std::sin(fix.flight_time_s / 12.0);
  }
  const Outcome outcome = reconstruct_case(c);
  expect_scale_and_tilt(outcome);
  EXPECT_NE(outcome.quality.georeference, GeoreferenceVerdict::kGood);
}

TEST_P(GnssFaults, OneTagFiveKilometresOffMovesNothing) {
  Case c = make_case(GetParam());
  *c.gnss.fixes[11].position_in_enu += Eigen::Vector3d(3000.0, -4000.0, 0.0);
  expect_scale_and_tilt(reconstruct_case(c));
}

TEST_P(GnssFaults, AltitudesOfTheWrongSignDoNotTurnTheModelOver) {
  Case c = make_case(GetParam());
  // 300 m above the sea, written as below it.
  for (PhotoFix& fix : c.gnss.fixes) {
    fix.position_in_enu->z() = -(fix.position_in_enu->z() - 65.0);
  }
  c.gnss.origin.altitude_m = -300.0;
  const Outcome outcome = reconstruct_case(c);
  expect_scale_and_tilt(outcome);
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kLimited);
}

TEST_P(GnssFaults, MissingAltitudesLeaveTheTiltToTheCameraMount) {
  Case c = make_case(GetParam());
  for (PhotoFix& fix : c.gnss.fixes) {
    fix.position_in_enu->z() = 0.0;
    fix.has_altitude = false;
  }
  const Outcome outcome = reconstruct_case(c);
  expect_scale_and_tilt(outcome);
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kLimited);
}

TEST_P(GnssFaults, LateTagsAreFoundByTheTurnsOfTheFlight) {
  Case c = make_case(GetParam(), 0.1);  // a drone keeps its line
  for (std::size_t v = 0; v < c.gnss.fixes.size(); ++v) {
    const double forth = (v / 8) % 2 == 0 ? 1.0 : -1.0;
    c.gnss.fixes[v].position_in_enu->x() -= 3.0 * forth * 7.0 / 2.5;
  }
  const Outcome outcome = reconstruct_case(c);
  expect_scale_and_tilt(outcome);
  EXPECT_TRUE(outcome.placement.errors.lag);
  EXPECT_NEAR(outcome.quality.flights[0].lag_s, 3.0, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, GnssFaults, ::testing::Values(1U, 2U));

TEST(GnssFaults, WithoutCameraMountABadTiltIsReported) {
  Case c = make_case(5);
  Random random(5, "test/white");
  for (std::size_t v = 0; v < c.photos.size(); ++v) {
    c.photos[v].gimbal.reset();
    *c.gnss.fixes[v].position_in_enu +=
        3.0 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  }
  const Outcome outcome = reconstruct_case(c);
  EXPECT_EQ(outcome.quality.georeference, GeoreferenceVerdict::kUnusable);
  EXPECT_LT(outcome.tilt_deg, 4.0 * outcome.quality.tilt_sigma_rad / kDegree);
}

TEST(TrackVelocities, BelongToTheLegOfThePhoto) {
  std::vector<TimedPosition> track;
  for (int i = 0; i < 5; ++i) track.push_back({.position = {4.0 * i, 0, 0}, .time_s = 2.0 * i});
  // Back on the next strip after a turn of 10 s.
  for (int i = 0; i < 5; ++i) {
    track.push_back({.position = {16.0 - 4.0 * i, 8, 0}, .time_s = 18.0 + 2.0 * i});
  }
  const auto velocities = track_velocities(track);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT((velocities[i] - Eigen::Vector3d(2, 0, 0)).norm(), 1e-12) << i;
    EXPECT_LT((velocities[i + 5] - Eigen::Vector3d(-2, 0, 0)).norm(), 1e-12) << i;
  }
}

TEST(TrackVelocities, AreUnknownAcrossFlightsAndLongGaps) {
  const std::vector<TimedPosition> track = {{.position = {0, 0, 0}, .flight = 0, .time_s = 0.0},
                                            {.position = {9, 0, 0}, .flight = 1, .time_s = 2.0},
                                            {.position = {9, 9, 0}, .flight = 1, .time_s = 60.0}};
  for (const Eigen::Vector3d& velocity : track_velocities(track)) EXPECT_EQ(velocity.norm(), 0.0);
}

}  // namespace
}  // namespace hybridfusion
