#include "loop_graph.hpp"

#include "rigid3_matchers.hpp"

#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

const GeodeticOrigin kOrigin{48.15, 11.57, 520.0};
const Eigen::Vector3d kAntenna(-0.45, 0.1, 0.52);
const Rigid3 kEnuFromMap{
    .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ())),
    .translation = {30.0, -12.0, 4.0}};

/// 80 s round a circle of `radius_m`, ten scans a second, five fixes a second.
struct Round {
  std::vector<StoredScan> scans = {};
  std::vector<Segment> segments = {};
  std::vector<GnssFix> fixes = {};
};

Rigid3 round_pose(double t, double radius_m) {
  const double angle = 0.06 * t;
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())),
          .translation = {radius_m * std::sin(angle), radius_m * (1.0 - std::cos(angle)), 0.0}};
}

Round make_round(double radius_m, double sigma_m, const Eigen::Vector3d& bias_m) {
  Round round;
  Random random(1, "test/round");
  for (int i = 0; i < 800; ++i) {
    round.scans.push_back(
        {.time = from_seconds(0.1 * i), .map_from_imu = round_pose(0.1 * i, radius_m)});
  }
  for (int i = 0; i < 400; ++i) {
    const double t = 0.2 * i + 0.03;  // between two scans
    const Eigen::Vector3d noise =
        0.1 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    round.fixes.push_back(
        {.time = from_seconds(t),
         .position = geodetic_from_enu(
             kOrigin, kEnuFromMap * (round_pose(t, radius_m) * kAntenna) + bias_m + noise),
         .sigma_enu_m = Eigen::Vector3d::Constant(sigma_m)});
  }
  round.segments = cut_into_segments(round.scans, 0.5);
  return round;
}

PoseGraph graph_of(const Round& round) {
  PoseGraph graph;
  add_gnss({.fixes = round.fixes, .antenna_in_imu = kAntenna}, round.segments, round.scans, graph);
  return graph;
}

TEST(LoopGraphGnss, HoldsTheAntennaWhereItWasEvenWithABiasedReceiver) {
  for (const double bias_m : {0.0, 7.0}) {
    const Round round = make_round(60.0, 1.5, {bias_m, -bias_m, 2.0 * bias_m});
    const PoseGraph graph = graph_of(round);
    ASSERT_GT(graph.positions.size(), round.segments.size() / 2);
    for (const PositionPrior& prior : graph.positions) {
      // What the bias shares with the whole track moves the track, not the map.
      const Rigid3& pose = round.scans[round.segments[prior.pose].anchor].map_from_imu;
      EXPECT_LT((pose * prior.lever_in_body - prior.point_in_map).norm(), 0.6);
    }
  }
}

TEST(LoopGraphGnss, IsWeakAsItsErrorsLastForMinutes) {
  const PoseGraph graph = graph_of(make_round(60.0, 1.5, Eigen::Vector3d::Zero()));
  ASSERT_FALSE(graph.positions.empty());
  // One fix in 120 s counts; there is one every half second.
  for (const PositionPrior& prior : graph.positions) {
    EXPECT_NEAR(prior.sigma_m, 1.5 * std::sqrt(120.0 / 0.5), 1.0);
  }
  const PoseGraph unstated = graph_of(make_round(60.0, 0.0, Eigen::Vector3d::Zero()));
  ASSERT_FALSE(unstated.positions.empty());
  EXPECT_GT(unstated.positions.front().sigma_m, 10.0);
}

TEST(LoopGraphGnss, AddsNothingFromATrackThatCannotBeAligned) {
  EXPECT_TRUE(
      graph_of(make_round(0.2, 1.5, Eigen::Vector3d::Zero())).positions.empty());  // on the spot
  Round round = make_round(60.0, 1.5, Eigen::Vector3d::Zero());
  for (GnssFix& fix : round.fixes) {
    fix.position.latitude_deg = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_TRUE(graph_of(round).positions.empty());
  round.fixes.clear();
  EXPECT_TRUE(graph_of(round).positions.empty());
}

TEST(LoopGraphGnss, LeavesSingleInvalidFixesOut) {
  Round round = make_round(60.0, 1.5, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < round.fixes.size(); i += 3) {
    round.fixes[i].position.altitude_m = std::numeric_limits<double>::infinity();
  }
  const PoseGraph graph = graph_of(round);
  EXPECT_FALSE(graph.positions.empty());
  for (const PositionPrior& prior : graph.positions) {
    EXPECT_TRUE(prior.point_in_map.allFinite());
  }
}

TEST(TotalStrain, AddsUpTheEdgesInStandardDeviations) {
  std::vector<RelativePose> odometry;
  std::vector<Rigid3> poses = {{}};
  for (std::uint32_t i = 0; i < 10; ++i) {
    odometry.push_back({.first = i,
                        .second = i + 1,
                        .first_from_second = {.translation = {1.0, 0.0, 0.0}},
                        .information = information_of(0.02, 0.004)});
    poses.push_back({.translation = {static_cast<double>(i + 1), 0.0, 0.0}});
  }
  EXPECT_NEAR(total_strain(odometry, poses), 0.0, 1e-12);
  for (std::size_t i = 6; i < poses.size(); ++i) poses[i].translation.x() += 0.1;
  EXPECT_NEAR(total_strain(odometry, poses), 5.0, 1e-9);
  for (std::size_t i = 3; i < poses.size(); ++i) poses[i].translation.y() -= 0.24;
  EXPECT_NEAR(total_strain(odometry, poses), 13.0, 1e-9);
}

}  // namespace
}  // namespace hybridfusion
