#include "scan_matching.hpp"

#include "deskew.hpp"
#include "iterated_update.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/lidar/odometry.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(FitPlane, FindsATiltedPlaneFarFromTheOrigin) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.2, 0.9).normalized();
  const Eigen::Vector3d u = normal.cross(Eigen::Vector3d::UnitX()).normalized();
  const Eigen::Vector3d v = normal.cross(u);
  MapNeighbors neighbors{.count = 5};
  const double uv[5][2] = {{0, 0}, {0.5, 0.1}, {-0.4, 0.3}, {0.1, -0.6}, {0.2, 0.5}};
  for (int i = 0; i < 5; ++i) {
    neighbors.points[i] =
        (Eigen::Vector3d(500, -300, 20) + uv[i][0] * u + uv[i][1] * v).cast<float>();
  }
  const auto plane = fit_plane(neighbors, 0.1);
  ASSERT_TRUE(plane);
  EXPECT_GT(std::abs(plane->normal.dot(normal)), 0.99999);  // float spacing at 500 m is 3e-5 m
  neighbors.points[2] += (0.5 * normal).cast<float>();
  EXPECT_FALSE(fit_plane(neighbors, 0.1));
}

TEST(FitPlane, RefusesPointsOnALine) {
  MapNeighbors neighbors{.count = 5};
  for (int i = 0; i < 5; ++i) {
    neighbors.points[i] = {static_cast<float>(i), 0.01F * static_cast<float>(i % 2), 0.0F};
  }
  EXPECT_FALSE(fit_plane(neighbors, 0.1));
}

TEST(FitPlane, RefusesLeaves) {
  MapNeighbors neighbors{.count = 5};
  const float xyz[5][3] = {
      {0.3F, 0, 0.08F}, {-0.3F, 0, 0.08F}, {0, 0.3F, -0.08F}, {0, -0.3F, -0.08F}, {0, 0, 0}};
  for (int i = 0; i < 5; ++i) neighbors.points[i] = {xyz[i][0], xyz[i][1], xyz[i][2]};
  EXPECT_FALSE(fit_plane(neighbors, 0.1));
  for (int i = 0; i < 5; ++i) neighbors.points[i].z() *= 0.2F;
  EXPECT_TRUE(fit_plane(neighbors, 0.1));
}

TEST(ContainsRay, TellsTheScannersPlaneFromAWall) {
  // Points of one level scan line over a rough facade lie in the level plane of scanning.
  MapNeighbors neighbors{.count = 5};
  const float depth[5] = {10.0F, 10.25F, 10.05F, 10.3F, 10.0F};
  for (int i = 0; i < 5; ++i) {
    neighbors.points[i] = {depth[i], 0.2F * static_cast<float>(i), 0.0F};
  }
  const auto plane = fit_plane(neighbors, 0.1);
  ASSERT_TRUE(plane);
  EXPECT_TRUE(contains_ray(*plane, {10.0, 0.4, 0.0}));
  EXPECT_FALSE(contains_ray(*plane, {10.0, 0.4, -3.0}));
  const Plane wall{.normal = {1.0, 0.0, 0.0}};
  EXPECT_FALSE(contains_ray(wall, {10.0, 4.0, 1.0}));
}

TEST(TrustedNormal, LosesWhatItBarelyFaces) {
  const WeakDirections along_x{.directions = {Eigen::Vector3d::UnitX()}, .count = 1};
  const Eigen::Vector3d wall = Eigen::Vector3d(0.05, 1.0, 0.0).normalized();
  EXPECT_EQ(trusted_normal(wall, along_x).x(), 0.0);
  EXPECT_EQ(trusted_normal(wall, along_x).y(), wall.y());
  const Eigen::Vector3d niche = Eigen::Vector3d(0.9, 0.2, 0.0).normalized();
  EXPECT_EQ(trusted_normal(niche, along_x), niche);
  EXPECT_EQ(trusted_normal(wall, {}), wall);
}

TEST(PointToPlane, RowAgreesWithDifferences) {
  NavState state;
  state.map_from_imu = so3_exp({0.1, 0.4, -0.8});
  state.position_in_map = {3.0, 2.0, 1.0};
  state.imu_from_lidar = so3_exp({0.02, -0.3, 0.1});
  state.lidar_in_imu = {0.2, -0.1, 0.4};
  const Plane plane{.normal = Eigen::Vector3d(1, 2, -1).normalized(), .center = {5, 5, 5}};
  const Eigen::Vector3d point_in_lidar(4.0, -7.0, 2.0);
  const auto residual = [&](const NavState& at) {
    return point_to_plane(at, at.imu_from_lidar * point_in_lidar + at.lidar_in_imu, plane, nullptr);
  };
  MatchVector row;
  (void)point_to_plane(
      state, state.imu_from_lidar * point_in_lidar + state.lidar_in_imu, plane, &row);
  constexpr double kH = 1e-6;
  for (int k = 0; k < kMatchSize; ++k) {
    const int at = k < kPoseSize ? k : err::kExtrinsicPosition + k - kPoseSize;
    const ErrorVector d = kH * ErrorVector::Unit(at);
    EXPECT_NEAR(row[k], (residual(plus(state, d)) - residual(plus(state, -d))) / (2 * kH), 1e-7);
  }
}

/// Map of three walls of a room and the points of a scan of them, seen from `state`.
struct Room {
  LocalMap map{LocalMapOptions{}};
  std::vector<Eigen::Vector3f> points = {};
};

Room make_room(const NavState& state, int num_walls) {
  Room room;
  Random random(9, "test/room");
  std::vector<Eigen::Vector3f> on_walls;
  for (int i = 0; i < 6000; ++i) {
    // The walls end before they meet: a voxel across an edge would hold a mean off both.
    Eigen::Vector3d p(random.uniform(1, 10), random.uniform(1, 10), random.uniform(1, 10));
    p[i % num_walls] = 0.0;
    on_walls.push_back(p.cast<float>());
    if (i % 10 == 0) {
      room.points.push_back(
          (state.map_from_imu.transpose() * (p - state.position_in_map)).cast<float>());
    }
  }
  room.map.insert(on_walls);
  return room;
}

StateEstimate loose_prior(const NavState& truth) {
  StateEstimate prior;
  prior.covariance.diagonal().head<6>().setConstant(0.04);
  ErrorVector off = ErrorVector::Zero();
  off.head<6>() << 0.08, -0.05, 0.06, 0.01, -0.012, 0.008;
  prior.state = plus(truth, off);
  return prior;
}

NavState true_state() {
  NavState truth;
  truth.position_in_map = {4.0, 5.0, 3.0};
  truth.map_from_imu = so3_exp({0.1, -0.2, 0.5});
  return truth;
}

TEST(IteratedUpdate, FindsThePoseBetweenThreeWalls) {
  const NavState truth = true_state();
  const Room room = make_room(truth, 3);
  const LidarFilterOptions options;
  ScanMatcher matcher(room.map, options);
  matcher.set_points(room.points);
  StateEstimate estimate = loose_prior(truth);
  const auto report = iterated_update(options, [](const auto&, auto&) {}, matcher, estimate);
  EXPECT_EQ(report.flags, 0U);
  EXPECT_GT(report.num_matched, 400);
  const ErrorVector error = minus(estimate.state, truth);
  EXPECT_LT(error.head<3>().norm(), 2e-3);
  EXPECT_LT(error.segment<3>(3).norm(), 5e-4);
  EXPECT_LT(estimate.covariance(0, 0), 1e-4);
}

TEST(IteratedUpdate, HoldsWhatOneWallDoesNotShow) {
  const NavState truth = true_state();
  const Room room = make_room(truth, 1);
  const LidarFilterOptions options;
  ScanMatcher matcher(room.map, options);
  matcher.set_points(room.points);
  StateEstimate estimate = loose_prior(truth);
  const StateEstimate prior = estimate;
  const auto report = iterated_update(options, [](const auto&, auto&) {}, matcher, estimate);
  EXPECT_NE(report.flags & static_cast<std::uint32_t>(ScanFlag::kDegenerate), 0U);
  EXPECT_NEAR(estimate.state.position_in_map.x(), truth.position_in_map.x(), 5e-3);
  EXPECT_NEAR(estimate.state.position_in_map.y(), prior.state.position_in_map.y(), 1e-3);
  EXPECT_NEAR(estimate.state.position_in_map.z(), prior.state.position_in_map.z(), 1e-3);
}

TEST(IteratedUpdate, KeepsThePredictionWithoutMatches) {
  const NavState truth = true_state();
  const Room room = make_room(truth, 3);
  const LidarFilterOptions options;
  ScanMatcher matcher(room.map, options);
  StateEstimate estimate = loose_prior(truth);
  estimate.state.position_in_map.x() += 50.0;
  const StateEstimate prior = estimate;
  matcher.set_points(room.points);
  const auto report = iterated_update(options, [](const auto&, auto&) {}, matcher, estimate);
  EXPECT_EQ(report.flags, static_cast<std::uint32_t>(ScanFlag::kUnmatched));
  EXPECT_EQ(estimate.state.position_in_map, prior.state.position_in_map);
}

TEST(CleanScan, DropsInvalidReturnsAndSortsByTime) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<LidarPoint> points(6);
  points[0] = {.point_in_lidar = {5, 0, 0}, .offset_ns = 30};
  points[1] = {.point_in_lidar = {nan, 0, 0}, .offset_ns = 20};
  points[2] = {.point_in_lidar = {0, 0, 0}, .offset_ns = 10};
  points[3] = {.point_in_lidar = {0, 200, 0}, .offset_ns = 5};
  points[4] = {.point_in_lidar = {0, 6, 0}, .offset_ns = -4};
  points[5] = {.point_in_lidar = {0.2F, 0, 0}, .offset_ns = 0};
  EXPECT_EQ(clean_scan(1.0, 100.0, points), 4U);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].offset_ns, -4);
  EXPECT_EQ(points[1].offset_ns, 30);
}

TEST(Deskew, PutsAPointSeenOnTheMoveWhereItIs) {
  NavState state;
  state.velocity_in_map = {8.0, 1.0, 0.0};
  state.imu_from_lidar = so3_exp({0.0, 0.1, -0.2});
  state.lidar_in_imu = {0.3, 0.0, 0.5};
  const Eigen::Vector3d target(12.0, -4.0, 2.0);
  std::vector<LidarPoint> points;
  std::vector<ImuStep> steps;
  for (int i = 0; i < 20; ++i) {
    const auto see = [&](const NavState& at, int offset_ns) {
      const Eigen::Vector3d in_imu = at.map_from_imu.transpose() * (target - at.position_in_map);
      points.push_back(
          {.point_in_lidar =
               (at.imu_from_lidar.transpose() * (in_imu - at.lidar_in_imu)).cast<float>(),
           .offset_ns = offset_ns});
    };
    const ImuStep step{.dt_s = 0.005,
                       .angular_velocity_radps = {0.1, -0.2, 1.5},
                       .specific_force_mps2 = {2.0, 1.0, 9.9}};
    see(state, i * 5'000'000);
    state = propagated(state, step);
    steps.push_back(step);
  }
  std::vector<LidarPoint> out;
  deskew(points, path_before(state, steps), state, 100'000'000, out);
  const Eigen::Vector3d expected =
      state.map_from_imu.transpose() * (target - state.position_in_map);
  for (const LidarPoint& point : out) {
    EXPECT_LT((point.point_in_lidar.cast<double>() - expected).norm(), 1e-5);
  }
}

TEST(Thin, KeepsThePointNearestToEachVoxelCentre) {
  std::vector<LidarPoint> points(4);
  points[0].point_in_lidar = {0.9F, 0.5F, 0.5F};
  points[1].point_in_lidar = {0.55F, 0.5F, 0.5F};
  points[2].point_in_lidar = {-0.1F, 0.5F, 0.5F};
  points[3].point_in_lidar = {0.1F, 0.5F, 0.5F};
  EXPECT_EQ(thin(points, 1.0), (std::vector<std::size_t>{1, 2}));
  EXPECT_TRUE(thin({}, 1.0).empty());
}

TEST(Thin, KeepsTheNearestToTheCentreOfManyVoxels) {
  Random random(4, "test/thin");
  std::vector<LidarPoint> points(20'000);
  for (LidarPoint& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      point.point_in_lidar[axis] = static_cast<float>(random.uniform(-10.0, 10.0));
    }
  }
  std::map<std::array<int, 3>, std::pair<float, std::size_t>> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3f floor = points[i].point_in_lidar.array().floor();
    const float distance2 = (points[i].point_in_lidar.array() - floor - 0.5F).square().sum();
    const std::array voxel{
        static_cast<int>(floor.x()), static_cast<int>(floor.y()), static_cast<int>(floor.z())};
    const auto [at, added] = nearest.try_emplace(voxel, distance2, i);
    if (!added && distance2 < at->second.first) at->second = {distance2, i};
  }
  std::vector<std::size_t> expected;
  for (const auto& [voxel, winner] : nearest) expected.push_back(winner.second);
  std::ranges::sort(expected);
  EXPECT_GT(expected.size(), 6000U);
  EXPECT_EQ(thin(points, 1.0), expected);
}

}  // namespace
}  // namespace hybridfusion
