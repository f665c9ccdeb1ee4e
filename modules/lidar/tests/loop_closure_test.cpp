#include "loop_verification.hpp"
#include "manifold.hpp"
#include "plan_search.hpp"
#include "rigid3_matchers.hpp"
#include "street_world.hpp"
#include "submap_alignment.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/lidar/mapper.hpp>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Submap random_walls(std::uint64_t seed) {
  Submap map;
  Random random(seed, "test/walls");
  for (int wall = 0; wall < 12; ++wall) {
    const Eigen::Vector2f start(static_cast<float>(random.uniform(-30.0, 30.0)),
                                static_cast<float>(random.uniform(-30.0, 30.0)));
    const bool along_x = random.uniform() < 0.5;
    for (int i = 0; i < 16; ++i) {
      const float at = 0.5F * static_cast<float>(i);
      map.walls.push_back(start +
                          (along_x ? Eigen::Vector2f(at, 0.0F) : Eigen::Vector2f(0.0F, at)));
    }
  }
  return map;
}

Submap moved(const Submap& map, const Rigid3& target_from_source) {
  const Rigid3 source_from_target = target_from_source.inverse();
  Submap out;
  for (const Eigen::Vector2f& wall : map.walls) {
    out.walls.push_back(
        (source_from_target * Eigen::Vector3d(wall.x(), wall.y(), 0.0)).head<2>().cast<float>());
  }
  for (const Surfel& surfel : map.surfels) {
    out.surfels.push_back(
        {.mean = (source_from_target * surfel.mean.cast<double>()).cast<float>(),
         .normal = (source_from_target.rotation * surfel.normal.cast<double>()).cast<float>()});
  }
  return out;
}

TEST(PlanSearch, FindsAPlaceWithinTheWindow) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Submap target = random_walls(seed);
    const Rigid3 pose{.rotation = Eigen::Quaterniond(so3_exp({0.0, 0.0, 0.07})),
                      .translation = {7.3, -11.2, 0.0}};
    const auto matches =
        search_plan(target, moved(target, pose), {.radius_m = 15.0, .yaw_rad = 0.15}, 0.3, 3);
    ASSERT_FALSE(matches.empty());
    EXPECT_NEAR(matches[0].pose.yaw_rad, 0.07, 0.02);
    EXPECT_LT((matches[0].pose.shift_m - Eigen::Vector2d(7.3, -11.2)).norm(), 0.8);
    EXPECT_GT(matches[0].score, 0.6);
  }
}

TEST(PlanSearch, FindsWhatTryingEveryShiftFinds) {
  const Submap target = random_walls(8);
  const Submap source = moved(target, {.translation = {2.1, 3.4, 0.0}});
  const auto fast = search_plan(target, source, {.radius_m = 5.0, .yaw_rad = 0.03}, 0.0, 1);
  double slow = 0.0;
  for (int turn = -2; turn <= 2; ++turn) {
    for (int x = -10; x <= 10; ++x) {
      for (int y = -10; y <= 10; ++y) {
        // A window of one pose: nothing to bound.
        const PlanWindow one{
            .centre = {.yaw_rad = turn * std::numbers::pi / 180.0, .shift_m = {0.5 * x, 0.5 * y}}};
        const auto match = search_plan(target, source, one, 0.0, 1);
        if (!match.empty()) slow = std::max(slow, match[0].score);
      }
    }
  }
  ASSERT_FALSE(fast.empty());
  EXPECT_NEAR(fast[0].score, slow, 1e-12);
}

TEST(PlanSearch, ReportsEveryPlaceThatLooksTheSame) {
  Submap street;
  for (int house = -3; house <= 3; ++house) {
    for (int i = 0; i < 8; ++i) {
      street.walls.emplace_back(10.0F * static_cast<float>(house) + 0.5F * static_cast<float>(i),
                                8.0F);
    }
  }
  const auto matches = search_plan(street, street, {.radius_m = 12.0}, 0.3, 3);
  ASSERT_EQ(matches.size(), 3U);
  EXPECT_LT(matches[0].pose.shift_m.norm(), 0.6);
  EXPECT_NEAR(std::abs(matches[1].pose.shift_m.x()), 10.0, 0.6);
  EXPECT_GT(matches[2].score, 0.8 * matches[0].score);
}

/// Faces on the walls and the floor of a hall; without `ends` of an endless corridor.
Submap hall(bool ends) {
  Submap map;
  for (float u = -19.5F; u < 20.0F; u += 1.0F) {
    for (float v = -4.5F; v < 5.0F; v += 1.0F) {
      map.surfels.push_back({.mean = {u, v, 0.0F}, .normal = {0, 0, 1}});
      map.surfels.push_back({.mean = {u, 5.0F, v + 5.0F}, .normal = {0, 1, 0}});
      map.surfels.push_back({.mean = {u, -5.0F, v + 5.0F}, .normal = {0, 1, 0}});
      if (ends && std::abs(u) > 19.0F) {
        map.surfels.push_back({.mean = {std::copysign(20.0F, u), v, 3.0F}, .normal = {1, 0, 0}});
      }
    }
  }
  return map;
}

TEST(AlignSubmaps, RecoversAPoseNearTheGuess) {
  const Rigid3 pose{.rotation = Eigen::Quaterniond(so3_exp({0.004, -0.006, 0.03})),
                    .translation = {0.5, -0.4, 0.3}};
  const auto alignment = align_submaps(hall(true), moved(hall(true), pose), {});
  ASSERT_TRUE(alignment);
  EXPECT_THAT(alignment->target_from_source, Rigid3Near(pose, 0.01, 0.002));
  EXPECT_GT(alignment->inlier_share, 0.9);
  EXPECT_GT(alignment->min_cosine2, 0.015);
}

TEST(AlignSubmaps, ShowsThatACorridorSlides) {
  const auto alignment = align_submaps(hall(false), hall(false), {.translation = {0.7, 0.1, 0.1}});
  ASSERT_TRUE(alignment);
  EXPECT_LT(alignment->min_cosine2, 1e-3);
  EXPECT_NEAR(alignment->target_from_source.translation.x(), 0.7, 0.05);  // as guessed
  EXPECT_NEAR(alignment->target_from_source.translation.y(), 0.0, 0.01);
}

TEST(ConsistentLoops, LeavesOutTheOneThatTellsSomethingElse) {
  std::vector<StoredScan> scans;
  for (int i = 0; i < 200; ++i) {
    scans.push_back({.time = from_seconds(0.1 * i),
                     .map_from_imu = {.translation = {1.0 * (i % 100), i < 100 ? 0.0 : 1.5, 0.0}}});
  }
  const DrivenWay way = driven_way(scans);
  std::vector<Loop> loops;
  for (std::size_t i = 10; i < 50; i += 10) {
    // The second visit was 1.5 m off: truly the same places.
    loops.push_back({.scans = {.first = i, .second = i + 100}, .first_from_second = {}});
  }
  loops[2].first_from_second.translation.x() = 4.0;
  const auto kept = consistent_loops({}, scans, way, loops);
  ASSERT_EQ(kept.size(), 3U);
  for (const Loop& loop : kept) EXPECT_NE(loop.scans.first, 30U);
  EXPECT_TRUE(consistent_loops({}, scans, way, {loops[0]}).empty());  // nobody backs it
}

Expected<MappingResult> map_world(const testing::SimulatedDrive& drive,
                                  const OdometryOptions& options,
                                  int num_threads) {
  auto mapper = LidarMapper::create(options, drive.rig, std::filesystem::temp_directory_path());
  EXPECT_TRUE(mapper);
  for (SensorMessage& message : testing::messages_of(drive)) mapper->add(std::move(message));
  return mapper->finish({.num_threads = num_threads});
}

TEST(CloseLoops, TakesBackTheDriftOfATunnel) {
  const testing::TunnelRound round = testing::tunnel_round(1, 8.0);
  const testing::SimulatedDrive drive = testing::simulate_drive(round.world, round.lap_s + 6.0, 1);
  const auto truth = [&](Timestamp time) {
    return round.world.pose(to_seconds(time) - testing::kDriveStart_s);
  };
  OdometryOptions options{.max_range_m = 60.0};
  const auto result = map_world(drive, options, 1);
  ASSERT_TRUE(result) << result.error().message;
  // Odometry is 0.2 m off after the tunnel.
  EXPECT_GT(result->max_loop_error_m, 0.1);
  EXPECT_TRUE(result->loops_applied);
  EXPECT_GE(result->num_loops, 5U);
  // Half of it: along the bare tunnel the IMU alone shares it out.
  EXPECT_LT(testing::trajectory_error_m(result->trajectory, truth), 0.1);
  const auto flagged = std::ranges::count_if(result->quality, [](const ScanQuality& quality) {
    return (quality.flags & static_cast<std::uint32_t>(ScanFlag::kLoopCorrected)) != 0;
  });
  EXPECT_LT(flagged, 300);  // the tunnel at most, not the streets

  const auto again = map_world(drive, options, 4);
  ASSERT_TRUE(again);
  for (std::size_t i = 0; i < result->trajectory.poses.size(); ++i) {
    ASSERT_EQ(result->trajectory.poses[i].map_from_body.translation,
              again->trajectory.poses[i].map_from_body.translation);
  }
  EXPECT_EQ(result->map.points, again->map.points);
}

TEST(CloseLoops, FlagsWhereItCorrectedTheOdometry) {
  // An accelerometer that wanders, with which the bare tunnel takes odometry far off.
  testing::TunnelRound round = testing::tunnel_round(2, 8.0);
  round.world.accel_bias_walk = 4e-3;
  const testing::SimulatedDrive drive = testing::simulate_drive(round.world, round.lap_s + 4.0, 2);
  OdometryOptions options{.max_range_m = 60.0};
  options.refine.enabled = false;
  const auto result = map_world(drive, options, 2);
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_TRUE(result->loops_applied) << result->max_loop_error_m;
  int in_the_tunnel = 0;
  int elsewhere = 0;
  for (const ScanQuality& scan : result->quality) {
    if ((scan.flags & static_cast<std::uint32_t>(ScanFlag::kLoopCorrected)) == 0) continue;
    const Rigid3 pose = round.world.pose(to_seconds(scan.time) - testing::kDriveStart_s);
    (pose.translation.y() > 50.0 ? in_the_tunnel : elsewhere) += 1;
  }
  EXPECT_GT(in_the_tunnel, 20) << result->max_loop_error_m;
  EXPECT_LT(elsewhere, in_the_tunnel / 4);
}

/// Two streets 20 m apart on which the same two houses stand every 30 m, and a long way round
/// between them.
testing::SimulatedDrive twin_streets() {
  testing::DriveWorld world;
  for (double x = -50.0; x < 140.0; x += 30.0) {
    // The row between the streets has the fronts of its neighbours on both of its sides.
    for (const double y : {-10.0, 10.0, 30.0}) {
      world.boxes.push_back({.min = {x, y - 2.5, 0}, .max = {x + 9, y + 2.5, 7}});
      world.boxes.push_back({.min = {x + 14, y - 2.0, 0}, .max = {x + 25, y + 2.0, 5}});
    }
  }
  world.max_range_m = 40.0;
  world.pose = testing::drive_along(
      {{0, 0}, {130, 0}, {130, -60}, {-45, -60}, {-45, 20}, {0, 20}, {300, 20}}, 10.0);
  return testing::simulate_drive(world, 58.0, 1);
}

TEST(CloseLoops, StreetsThatLookTheSameDoNotBendTheDrive) {
  const testing::SimulatedDrive drive = twin_streets();
  OdometryOptions options{.max_range_m = 60.0};
  options.refine.enabled = false;
  options.loop_closure.drift_ratio = 0.08;  // far enough to take one street for the other
  const auto with = map_world(drive, options, 1);
  ASSERT_TRUE(with) << with.error().message;
  EXPECT_GT(with->num_loop_candidates, 3U);
  EXPECT_GT(with->num_loops, 0U);  // they pass every test that looks at places alone
  EXPECT_GT(with->max_loop_error_m, 15.0);
  EXPECT_FALSE(with->loops_applied);
  EXPECT_TRUE(std::ranges::any_of(with->warnings, [](const std::string& warning) {
    return warning.find("would bend the odometry") != std::string::npos;
  }));
  options.loop_closure.enabled = false;
  const auto without = map_world(drive, options, 1);
  ASSERT_TRUE(without);
  for (std::size_t i = 0; i < with->trajectory.poses.size(); ++i) {
    ASSERT_EQ(with->trajectory.poses[i].map_from_body.translation,
              without->trajectory.poses[i].map_from_body.translation);
    EXPECT_EQ(with->quality[i].flags, without->quality[i].flags);
  }
}

TEST(CloseLoops, LeavesADriveWithoutRevisitsAlone) {
  const testing::DriveWorld world = testing::lookalike_street(8.0);
  const testing::SimulatedDrive drive = testing::simulate_drive(world, 25.0, 1);
  OdometryOptions options{.max_range_m = 60.0};
  options.refine.enabled = false;
  options.loop_closure.drift_ratio = 0.3;  // as if odometry could not be trusted at all
  const auto with = map_world(drive, options, 1);
  options.loop_closure.enabled = false;
  const auto without = map_world(drive, options, 1);
  ASSERT_TRUE(with && without);
  EXPECT_EQ(with->num_loops, 0U);
  EXPECT_FALSE(with->loops_applied);
  for (std::size_t i = 0; i < with->trajectory.poses.size(); ++i) {
    ASSERT_EQ(with->trajectory.poses[i].map_from_body.translation,
              without->trajectory.poses[i].map_from_body.translation);
  }
}

}  // namespace
}  // namespace hybridfusion
