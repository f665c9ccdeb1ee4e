#include "rigid3_matchers.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/lidar/gnss_alignment.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

const GeodeticOrigin kOrigin{48.15, 11.57, 520.0};
const Eigen::Vector3d kAntenna(-0.45, 0.1, 0.52);
const Rigid3 kTruth{
    .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(2.2, Eigen::Vector3d::UnitZ())),
    .translation = {30.0, -12.0, 4.0}};

struct Track {
  Trajectory trajectory = {};
  std::vector<GnssFix> fixes = {};
};

Track make_track(double radius_m, double sigma_m, std::uint64_t seed) {
  Track track;
  Random random(seed, "test/gnss");
  for (int i = 0; i < 400; ++i) {
    const double f = 0.015 * i;
    track.trajectory.poses.push_back(
        {.time = from_seconds(0.1 * i),
         .map_from_body = {
             .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(f, Eigen::Vector3d::UnitZ())),
             .translation = {radius_m * std::sin(f), -radius_m * std::cos(f), 0.0}}});
    if (i % 2 != 0) continue;
    const Eigen::Vector3d antenna =
        kTruth * (track.trajectory.poses.back().map_from_body * kAntenna) +
        sigma_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    track.fixes.push_back({.time = from_seconds(0.1 * i),
                           .position = geodetic_from_enu(kOrigin, antenna),
                           .sigma_enu_m = Eigen::Vector3d::Constant(sigma_m)});
  }
  return track;
}

Expected<GnssAlignment> align(const Track& track) {
  return align_gnss(track.trajectory, track.fixes, kOrigin, kAntenna, {});
}

TEST(AlignGnss, RecoversYawAndTranslationExactlyWithoutNoise) {
  const auto alignment = align(make_track(20.0, 0.0, 1));
  ASSERT_TRUE(alignment) << alignment.error().message;
  EXPECT_THAT(alignment->enu_from_map, Rigid3Near(kTruth, 1e-5, 1e-6));
  EXPECT_EQ(alignment->num_outliers, 0U);
  EXPECT_LT(alignment->rms_horizontal_m, 1e-5);
}

TEST(AlignGnss, StaysWithinItsOwnCovariance) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto alignment = align(make_track(25.0, 1.0, seed));
    ASSERT_TRUE(alignment);
    const double yaw_error = std::remainder(alignment->yaw_rad - 2.2, 2.0 * M_PI);
    EXPECT_LT(std::abs(yaw_error), 4.0 * std::sqrt(alignment->covariance(3, 3)));
    EXPECT_LT(std::abs(yaw_error), 0.02);
    EXPECT_NEAR(alignment->rms_vertical_m, 1.0, 0.3);
  }
}

TEST(AlignGnss, IgnoresOutliersAndInvalidFixes) {
  Track track = make_track(20.0, 0.5, 3);
  for (std::size_t i = 0; i < track.fixes.size(); i += 5) {
    track.fixes[i].position.latitude_deg += 0.05;  // 5 km
  }
  track.fixes[1].position = {};  // (0, 0)
  track.fixes[2].position.altitude_m = std::numeric_limits<double>::quiet_NaN();
  const auto alignment = align(track);
  ASSERT_TRUE(alignment) << alignment.error().message;
  EXPECT_THAT(alignment->enu_from_map, Rigid3Near(kTruth, 0.4, 0.02));
  EXPECT_GE(alignment->num_outliers, 40U);
}

TEST(AlignGnss, NeedsTheLeverArm) {
  const Track track = make_track(20.0, 0.0, 4);
  const auto without =
      align_gnss(track.trajectory, track.fixes, kOrigin, Eigen::Vector3d::Zero(), {});
  ASSERT_TRUE(without);
  EXPECT_NEAR((without->enu_from_map.translation - kTruth.translation).z(), 0.52, 1e-3);
}

TEST(AlignGnss, RefusesATrackTooShortForItsNoise) {
  const auto noisy = align(make_track(1.0, 2.0, 5));
  ASSERT_FALSE(noisy);
  EXPECT_EQ(noisy.error().code, ErrorCode::kDegenerate);
  EXPECT_NE(noisy.error().message.find("drive farther"), std::string::npos);
  EXPECT_EQ(align(make_track(0.0, 0.5, 5)).error().code, ErrorCode::kDegenerate);
}

TEST(AlignGnss, RefusesTooFewFixes) {
  Track track = make_track(20.0, 0.5, 6);
  track.fixes.resize(4);
  EXPECT_EQ(align(track).error().code, ErrorCode::kInsufficient);
  EXPECT_EQ(align({}).error().code, ErrorCode::kInsufficient);
  track = make_track(20.0, 0.5, 6);
  for (GnssFix& fix : track.fixes) fix.time += std::chrono::hours(1);
  EXPECT_EQ(align(track).error().code, ErrorCode::kInsufficient);
}

TEST(AlignGnss, TellsAContradictionFromNoise) {
  // The receiver went a straight 400 m while the trajectory went round in circles.
  Track track = make_track(20.0, 1.5, 3);
  for (std::size_t i = 0; i < track.fixes.size(); ++i) {
    track.fixes[i].position =
        geodetic_from_enu(kOrigin, Eigen::Vector3d(2.0 * static_cast<double>(i), 0.0, 0.0));
  }
  const auto alignment = align(track);
  ASSERT_TRUE(alignment) << alignment.error().message;
  EXPECT_NE(alignment->contradiction.find("contradict the trajectory"), std::string::npos);
  // A receiver that is worse than it says is none, nor is a stretch of bad fixes.
  Track optimistic = make_track(20.0, 1.5, 4);
  for (GnssFix& fix : optimistic.fixes) fix.sigma_enu_m.setConstant(0.1);
  for (std::size_t i = 0; i < optimistic.fixes.size() / 4; ++i) {
    optimistic.fixes[i].position.latitude_deg += 3e-4;
  }
  const auto kept = align(optimistic);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(kept->contradiction, "");
}

}  // namespace
}  // namespace hybridfusion
