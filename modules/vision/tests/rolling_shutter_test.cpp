#include "rolling_shutter.hpp"

#include "bundle_adjustment.hpp"
#include "incremental_mapper.hpp"
#include "shutter_adjustment.hpp"
#include "synthetic_flight.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

constexpr double kReadout_s = 0.05;
constexpr double kSpeed_mps = 5.6;

struct Case {
  testing::SyntheticFlight flight;
  SfmModel seen;  // as a rolling shutter shows it
  std::vector<Eigen::Vector3d> velocity;
  std::vector<double> readout_s;
};

/// Each row of a photo is projected from where the camera was when it was read.
Case make_case() {
  Case c;
  c.flight = testing::make_flight({.jitter_m = 0.1, .noise_px = 0.0});
  c.seen = c.flight.truth;
  for (std::size_t v = 0; v < c.seen.world_from_view.size(); ++v) {
    c.velocity.emplace_back((v / 4) % 2 == 0 ? kSpeed_mps : -kSpeed_mps, 0.0, 0.0);
    c.readout_s.push_back(kReadout_s);
  }
  for (std::size_t t = 0; t < c.seen.tracks.size(); ++t) {
    for (TrackElement& element : c.seen.tracks[t]) {
      const Rigid3 middle = *c.seen.world_from_view[element.view];
      for (int round = 0; round < 5; ++round) {
        const double time_s = (element.pixel.y() / 1200.0 - 0.5) * kReadout_s;
        const Rigid3 row{.rotation = middle.rotation,
                         .translation = middle.translation + time_s * c.velocity[element.view]};
        element.pixel = project(c.seen.camera_of(element.view), row.inverse() * *c.seen.points[t]);
      }
    }
  }
  return c;
}

double rms_px(const SfmModel& a, const SfmModel& b) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t t = 0; t < a.tracks.size(); ++t) {
    for (std::size_t k = 0; k < a.tracks[t].size(); ++k) {
      sum += (a.tracks[t][k].pixel - b.tracks[t][k].pixel).squaredNorm();
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

TEST(RollingShutter, PixelsComeBackToWhereTheMiddleRowSeesThem) {
  const Case c = make_case();
  SfmModel model = c.seen;
  // 5.6 m/s in 50 ms is 0.28 m at 65 m: 5.6 px from the first row to the last.
  EXPECT_GT(rms_px(model, c.flight.truth), 1.0);
  const auto report = correct_rolling_shutter(model, c.readout_s, c.velocity);
  EXPECT_EQ(report.num_views, model.world_from_view.size());
  EXPECT_NEAR(report.largest_px, 2.8, 0.7);
  EXPECT_LT(rms_px(model, c.flight.truth), 0.03);
}

TEST(RollingShutter, OneMoreAdjustmentAfterTheCorrectionFindsThePoses) {
  const Case c = make_case();
  const auto adjusted = [&](SfmModel model) {
    AdjustmentRequest request;
    request.free_views = model.registered();
    request.tracks = select_tracks(model, 0);
    request.calibration = CalibrationLevel::kFull;
    request.sigma_px = 0.5;
    GnssTerms gnss;
    for (const std::uint32_t view : model.registered()) {
      gnss.observations.push_back({.view = view,
                                   .position = c.flight.truth.world_from_view[view]->translation,
                                   .sigma_m = Eigen::Vector3d::Constant(1.0)});
    }
    request.gnss = &gnss;
    const auto summary = adjust(model, request, {}, {});
    EXPECT_TRUE(summary);
    return model;
  };
  const auto error_px = [&](const SfmModel& model) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t t = 0; t < model.tracks.size(); ++t) {
      for (const TrackElement& element : model.tracks[t]) {
        sum += std::pow(model.error_px(element, *model.points[t]), 2.0);
        count += 1.0;
      }
    }
    return std::sqrt(sum / count);
  };
  SfmModel model = adjusted(c.seen);
  const double before_px = error_px(model);
  correct_rolling_shutter(model, c.readout_s, c.velocity);
  model = adjusted(model);
  EXPECT_LT(error_px(model), 0.1 * before_px);
  EXPECT_LT(error_px(model), 0.05);
}

/// Adjusts a flight of cameras that the table has with 47 ms; every row was read at once in `model`
/// or within `c.readout_s`. @returns the model, its tags being true.
SfmModel adjusted_by_table(const Case& c, SfmModel model) {
  GnssIngest gnss;
  std::vector<PhotoMetadata> metadata(model.world_from_view.size());
  for (std::uint32_t v = 0; v < metadata.size(); ++v) {
    metadata[v].model = "L1D-20c";
    gnss.by_time.push_back(v);
    PhotoFix fix{.position_in_enu = c.flight.truth.world_from_view[v]->translation};
    fix.sigma_m = Eigen::Vector3d::Constant(1.0);
    fix.has_altitude = true;
    fix.flight_time_s = 14.0 / kSpeed_mps * v + 3.0 * (v / 4);  // turns take longer
    gnss.fixes.push_back(fix);
  }
  ReconstructionOptions options;
  GnssTerms terms = gnss_terms(model, gnss, options.gnss, {});
  const auto done = adjust_with_shutter(model, terms, {gnss, metadata, {}, options}, {});
  EXPECT_TRUE(done) << done.error().message;
  return model;
}

TEST(RollingShutter, AReadoutOfTheTableIsTakenWherePhotosAgreeBetterWithIt) {
  const Case c = make_case();  // 50 ms
  const SfmModel model = adjusted_by_table(c, c.seen);
  EXPECT_GT(rms_px(model, c.seen), 1.0);
}

TEST(RollingShutter, AReadoutOfTheTableIsNotTakenWherePhotosAgreeWorseWithIt) {
  const Case c = make_case();
  const SfmModel model = adjusted_by_table(c, c.flight.truth);  // all rows at once
  EXPECT_EQ(rms_px(model, c.flight.truth), 0.0);
}

TEST(RollingShutter, SlowFlightsAndUnknownSpeedsStay) {
  const Case c = make_case();
  SfmModel model = c.seen;
  std::vector<Eigen::Vector3d> slow(c.velocity.size(), Eigen::Vector3d(0.3, 0.0, 0.0));
  slow[1].setZero();
  EXPECT_EQ(correct_rolling_shutter(model, c.readout_s, slow).num_views, 0U);
  EXPECT_EQ(rms_px(model, c.seen), 0.0);
}

TEST(RollingShutter, ReadoutComesFromTheOptionTheTableOrNothing) {
  std::vector<PhotoMetadata> photos(2);
  photos[0].model = "FC300S";
  photos[1].model = "a camera with a central shutter";
  EXPECT_EQ(readout_times(photos, {}), (std::vector<double>{0.033, 0.0}));
  EXPECT_EQ(readout_times(photos, {.readout_ms = 40.0}), (std::vector<double>{0.04, 0.04}));
  EXPECT_EQ(readout_times(photos, {.correction = "off"}), (std::vector<double>{0.0, 0.0}));
}

}  // namespace
}  // namespace hybridfusion
