#include "bundle_adjustment.hpp"

#include "gnss_adjustment.hpp"
#include "incremental_mapper.hpp"
#include "rotation.hpp"
#include "synthetic_flight.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// The truth with calibration, poses and points disturbed.
SfmModel disturbed(const SfmModel& truth, double distance_m, double angle_rad) {
  SfmModel model = truth;
  Random random(9, "test/disturb");
  const auto vector = [&] {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  };
  model.cameras[0] = model.priors[0].intrinsics;
  for (auto& pose : model.world_from_view) {
    pose->translation += distance_m * vector();
    pose->rotation = pose->rotation * rotation_exp(angle_rad * vector());
  }
  for (auto& point : model.points) *point += distance_m * vector();
  return model;
}

GnssTerms exact_gnss(const SfmModel& truth, double sigma_m) {
  GnssTerms terms;
  for (const std::uint32_t view : truth.registered()) {
    terms.observations.push_back({.view = view,
                                  .position = truth.world_from_view[view]->translation,
                                  .sigma_m = Eigen::Vector3d::Constant(sigma_m),
                                  .flight_time_s = 2.5 * view});
  }
  return terms;
}

AdjustmentRequest whole(const SfmModel& model) {
  AdjustmentRequest request;
  request.free_views = model.registered();
  request.tracks = select_tracks(model, 0);
  request.calibration = CalibrationLevel::kFull;
  request.sigma_px = 0.3;
  return request;
}

double centre_rms_m(const SfmModel& model, const SfmModel& truth) {
  double sum2 = 0.0;
  for (std::size_t v = 0; v < truth.world_from_view.size(); ++v) {
    sum2 += (model.world_from_view[v]->translation - truth.world_from_view[v]->translation)
                .squaredNorm();
  }
  return std::sqrt(sum2 / static_cast<double>(truth.world_from_view.size()));
}

TEST(BundleAdjustment, RecoversPosesAndCalibrationFromNoisyPixels) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.3, 0.003);
  GnssTerms gnss = exact_gnss(flight.truth, 0.05);
  AdjustmentRequest request = whole(model);
  request.gnss = &gnss;
  const auto summary = adjust(model, request, {}, {});
  ASSERT_TRUE(summary);
  EXPECT_LT(summary->final_cost, 0.1 * summary->initial_cost);
  // 0.3 px at 65 m is 1.5 cm on the ground for one ray; some 250 rays hold a view.
  EXPECT_LT(centre_rms_m(model, flight.truth), 0.04);
  EXPECT_NEAR(model.cameras[0].focal_px, 1290.0, 1.5);
  EXPECT_NEAR(model.cameras[0].k1, -0.045, 0.005);
  EXPECT_NEAR(model.cameras[0].principal_point_px.x(), 803.0, 1.0);
}

TEST(BundleAdjustment, PosesScatterAsTheirCovarianceSays) {
  double sum = 0.0;
  double count = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto flight = testing::make_flight({.num_points = 150, .seed = seed});
    SfmModel model = disturbed(flight.truth, 0.1, 0.001);
    GnssTerms gnss = exact_gnss(flight.truth, 0.05);
    Random random(seed, "test/gnss");
    for (auto& o : gnss.observations) {
      o.position += 0.05 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    }
    AdjustmentRequest request = whole(model);
    request.gnss = &gnss;
    request.covariance = true;
    ASSERT_TRUE(adjust(model, request, {}, {}));
    ASSERT_EQ(model.pose_covariance.size(), model.world_from_view.size());
    for (const std::uint32_t view : model.registered()) {
      ASSERT_TRUE(model.pose_covariance[view]);
      const Eigen::Matrix3d covariance = model.pose_covariance[view]->topLeftCorner<3, 3>();
      const Eigen::Vector3d error = model.world_from_view[view]->translation -
                                    flight.truth.world_from_view[view]->translation;
      sum += error.dot(covariance.inverse() * error);
      count += 3.0;
    }
  }
  // Chi-square per degree of freedom; views of one block are correlated, so that it scatters.
  EXPECT_GT(sum / count, 0.4);
  EXPECT_LT(sum / count, 2.5);
}

TEST(BundleAdjustment, FixedViewsDoNotMove) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.1, 0.001);
  AdjustmentRequest request = whole(model);
  request.calibration = CalibrationLevel::kFixed;
  request.fixed_views = {0, 1, 2};
  request.free_views = {3, 4, 5};
  const Rigid3 before = *model.world_from_view[1];
  const CameraIntrinsics camera = model.cameras[0];
  ASSERT_TRUE(adjust(model, request, {}, {}));
  EXPECT_EQ(model.world_from_view[1]->translation, before.translation);
  EXPECT_EQ(model.cameras[0].focal_px, camera.focal_px);
  EXPECT_NE(model.world_from_view[4]->translation,
            disturbed(flight.truth, 0.1, 0.001).world_from_view[4]->translation);
}

TEST(BundleAdjustment, OneWildGnssPositionDoesNotBendTheModel) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.2, 0.002);
  GnssTerms gnss = exact_gnss(flight.truth, 0.05);
  gnss.observations[5].position += Eigen::Vector3d(0.0, 0.0, 300.0);
  AdjustmentRequest request = whole(model);
  request.gnss = &gnss;
  ASSERT_TRUE(adjust(model, request, {}, {}));
  EXPECT_LT(centre_rms_m(model, flight.truth), 0.05);
}

TEST(BundleAdjustment, DriftOfTheAltitudesIsFoundWhereItIsAllowed) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.1, 0.001);
  GnssTerms gnss = exact_gnss(flight.truth, 0.05);
  for (auto& o : gnss.observations) o.position.z() += 0.02 * o.flight_time_s;
  gnss.estimate_drift = true;
  AdjustmentRequest request = whole(model);
  request.gnss = &gnss;
  ASSERT_TRUE(adjust(model, request, {}, {}));
  EXPECT_NEAR(gnss.flights[0].rate_mps, 0.02, 0.01);
}

TEST(BundleAdjustment, DisplacementFormKeepsScaleAndForgetsTheOffset) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.05, 0.001);
  // A model 2 % too large: displacements must bring it back, a common offset must not move it.
  for (auto& pose : model.world_from_view) pose->translation *= 1.02;
  for (auto& point : model.points) *point *= 1.02;
  GnssTerms gnss = exact_gnss(flight.truth, 0.05);
  for (auto& o : gnss.observations) o.position += Eigen::Vector3d(100.0, 200.0, -50.0);
  gnss.form = GnssForm::kDisplacement;
  AdjustmentRequest request = whole(model);
  request.max_iterations = 100;
  request.gnss = &gnss;
  ASSERT_TRUE(adjust(model, request, {}, {}));
  const auto span = [](const SfmModel& m) {
    return (m.world_from_view.front()->translation - m.world_from_view[3]->translation).norm();
  };
  EXPECT_NEAR(span(model) / span(flight.truth), 1.0, 0.003);
  EXPECT_LT(centre_rms_m(model, flight.truth), 5.0);
}

TEST(BundleAdjustment, WithoutAnyPointItRefuses) {
  const auto flight = testing::make_flight();
  SfmModel model = flight.truth;
  AdjustmentRequest request;
  request.free_views = model.registered();
  EXPECT_EQ(adjust(model, request, {}, {}).error().code, ErrorCode::kInsufficient);
}

TEST(BundleAdjustment, StopTokenCancels) {
  const auto flight = testing::make_flight();
  SfmModel model = disturbed(flight.truth, 0.3, 0.003);
  std::stop_source source;
  source.request_stop();
  RunContext ctx;
  ctx.stop = source.get_token();
  EXPECT_EQ(adjust(model, whole(model), {}, ctx).error().code, ErrorCode::kCancelled);
}

TEST(GnssResiduals, AreVisionLessGnssPlusTheModelledDrift) {
  const auto flight = testing::make_flight();
  GnssTerms gnss = exact_gnss(flight.truth, 1.0);
  gnss.observations[1].position += Eigen::Vector3d(1.0, 0.0, 2.0);
  gnss.flights = {{.offset_m = 0.5, .rate_mps = 0.1}};
  const auto residuals = gnss_residuals(flight.truth, gnss);
  EXPECT_LT((residuals[1] - Eigen::Vector3d(-1.0, 0.0, -2.0 + 0.5 + 0.25)).norm(), 1e-12);
}

}  // namespace
}  // namespace hybridfusion
