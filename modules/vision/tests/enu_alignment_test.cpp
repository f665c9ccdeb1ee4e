#include "enu_alignment.hpp"

#include "gravity_cue.hpp"
#include "synthetic_flight.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Case {
  SfmModel model;  // in an arbitrary frame
  GnssIngest gnss;
  std::vector<PhotoMetadata> photos;
  Sim3 enu_from_world;
};

Case make_case(double sigma_m, std::uint64_t seed, const testing::FlightOptions& options = {}) {
  Case c;
  const auto flight = testing::make_flight(options);
  c.model = flight.truth;
  c.enu_from_world = {
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, 3).normalized())),
      .translation = {5, 6, 7},
      .scale = 9.0};
  Random random(seed, "test/gnss");
  for (std::size_t v = 0; v < flight.time_s.size(); ++v) {
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    PhotoFix fix;
    fix.position_in_enu = c.model.world_from_view[v]->translation + sigma_m * noise;
    fix.sigma_m = {3.0, 3.0, 6.0};
    fix.has_altitude = true;
    c.gnss.fixes.push_back(fix);
    c.gnss.by_time.push_back(v);
    c.photos.emplace_back();
  }
  transform_model(c.model, c.enu_from_world.inverse());
  return c;
}

double tilt_deg(const Case& c, const Sim3& found) {
  const Eigen::Vector3d up = c.enu_from_world.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  return std::acos(std::min(1.0, (found.rotation * up).z())) * 180.0 / M_PI;
}

void drift_altitudes(Case& c, double total_m) {
  const auto count = static_cast<double>(c.gnss.fixes.size());
  for (std::size_t i = 0; i < c.gnss.fixes.size(); ++i) {
    c.gnss.fixes[i].position_in_enu->z() += total_m * static_cast<double>(i) / count;
  }
}

TEST(AlignToEnu, GoodGnssIsTrusted) {
  const Case c = make_case(0.5, 1);
  const auto alignment = align_to_enu(c.model, c.gnss, c.photos, Random(1, "test"));
  ASSERT_TRUE(alignment);
  EXPECT_TRUE(alignment->altitude_trusted);
  EXPECT_LT(tilt_deg(c, alignment->enu_from_world), 3.0);
  EXPECT_NEAR(alignment->enu_from_world.scale / c.enu_from_world.scale, 1.0, 0.03);
}

TEST(AlignToEnu, DriftingAltitudesDoNotTiltTheModel) {
  Case c = make_case(0.5, 2);
  drift_altitudes(c, 110.0);
  const auto alignment = align_to_enu(c.model, c.gnss, c.photos, Random(1, "test"));
  ASSERT_TRUE(alignment);
  EXPECT_FALSE(alignment->altitude_trusted);
  EXPECT_FALSE(alignment->warnings.empty());
  EXPECT_LT(tilt_deg(c, alignment->enu_from_world), 3.0);
  EXPECT_NEAR(alignment->enu_from_world.scale / c.enu_from_world.scale, 1.0, 0.05);
}

TEST(AlignToEnu, GimbalAnglesOverruleConsistentlyTiltedAltitudes) {
  Case c = make_case(0.2, 3);
  for (std::size_t v = 0; v < c.photos.size(); ++v) {
    // Undo the synthetic lean: this is what the mount would report.
    const Eigen::Matrix3d r =
        (c.enu_from_world.rotation * c.model.world_from_view[v]->rotation).toRotationMatrix();
    c.photos[v].gimbal = GimbalAngles{.pitch_deg = std::asin(r(2, 2)) * 180.0 / M_PI};
    c.photos[v].gimbal->roll_deg = std::atan2(-r(2, 0), -r(2, 1)) * 180.0 / M_PI;
  }
  // A plane tilted by 15 degrees fits the wrong altitudes perfectly: no residual shows it.
  for (auto& fix : c.gnss.fixes) {
    fix.position_in_enu->z() += 0.27 * fix.position_in_enu->x();
    fix.sigma_m = Eigen::Vector3d::Constant(0.3);
  }
  const auto alignment = align_to_enu(c.model, c.gnss, c.photos, Random(1, "test"));
  ASSERT_TRUE(alignment);
  EXPECT_FALSE(alignment->altitude_trusted);
  EXPECT_LT(tilt_deg(c, alignment->enu_from_world), 1.0);
}

TEST(AlignToEnu, FlightUpAFacadeIsNotTakenForANadirFlight) {
  // The same flight turned upright: all photos look north, positions span height and width.
  Case c = make_case(0.0, 6);
  const Eigen::AngleAxisd upright(M_PI / 2.0, Eigen::Vector3d::UnitX());
  for (auto& fix : c.gnss.fixes) fix.position_in_enu = upright * *fix.position_in_enu;
  const auto alignment = align_to_enu(c.model, c.gnss, c.photos, Random(1, "test"));
  ASSERT_TRUE(alignment);
  EXPECT_TRUE(alignment->altitude_trusted);
  EXPECT_NEAR(alignment->enu_from_world.scale / c.enu_from_world.scale, 1.0, 0.01);
  EXPECT_NEAR(tilt_deg(c, alignment->enu_from_world), 90.0, 1.0);
}

TEST(AlignToEnu, OneStraightLineIsPlacedByTheViewingDirection) {
  const Case c = make_case(0.3, 4, {.columns = 12, .rows = 1, .tilt_rad = 0.02});
  Case line = c;
  for (std::size_t v = 0; v < line.photos.size(); ++v) {
    // Exactly on a line: GNSS leaves the roll about it open.
    line.gnss.fixes[v].position_in_enu = Eigen::Vector3d(14.0 * static_cast<double>(v), 0.0, 65.0);
    line.model.world_from_view[v]->translation =
        c.enu_from_world.inverse() * *line.gnss.fixes[v].position_in_enu;
  }
  const auto alignment = align_to_enu(line.model, line.gnss, line.photos, Random(1, "test"));
  ASSERT_TRUE(alignment);
  EXPECT_LT(tilt_deg(c, alignment->enu_from_world), 3.0);
}

TEST(AlignToEnu, TwoPositionsAreRefused) {
  Case c = make_case(0.5, 5);
  for (std::size_t i = 2; i < c.gnss.fixes.size(); ++i) c.gnss.fixes[i].position_in_enu.reset();
  EXPECT_EQ(align_to_enu(c.model, c.gnss, c.photos, Random(1, "test")).error().code,
            ErrorCode::kInsufficient);
}

TEST(GravityCue, LevelRowsOfObliqueViewsAllAroundGiveUp) {
  SfmModel model;
  for (int i = 0; i < 8; ++i) {
    const double heading = i * M_PI / 4.0;
    const Eigen::Quaterniond oblique = testing::looking_down(heading, 0.7);
    model.world_from_view.push_back(Rigid3{.rotation = oblique});
  }
  const auto cue = gravity_from_level_rows(model);
  ASSERT_TRUE(cue);
  EXPECT_GT(cue->up_in_world.z(), 0.9999);
}

TEST(GravityCue, ParallelRowsSayNothing) {
  SfmModel model;
  for (int i = 0; i < 8; ++i) {
    model.world_from_view.push_back(Rigid3{.rotation = testing::looking_down(0.0, 0.1 * i)});
  }
  EXPECT_FALSE(gravity_from_level_rows(model));
}

}  // namespace
}  // namespace hybridfusion
