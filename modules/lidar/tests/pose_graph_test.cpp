#include "pose_graph.hpp"

#include "manifold.hpp"
#include "rigid3_matchers.hpp"

#include <hybridfusion/core/random.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Rigid3 random_pose(Random& random, double turn_rad, double shift_m) {
  const auto vector = [&](double size) {
    return Eigen::Vector3d(
        random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  return {.rotation = Eigen::Quaterniond(so3_exp(vector(turn_rad))),
          .translation = vector(shift_m)};
}

Rigid3 moved(const Rigid3& pose, int parameter, double step) {
  PoseVector delta = PoseVector::Zero();
  delta[parameter] = step;
  Rigid3 out = pose;
  out.translation += delta.head<3>();
  out.rotation = pose.rotation * Eigen::Quaterniond(so3_exp(delta.tail<3>()));
  return out;
}

TEST(RelativePose, HasTheJacobiansOfItsResidual) {
  Random random(1, "test/relative_pose");
  constexpr double kStep = 1e-6;
  for (int trial = 0; trial < 50; ++trial) {
    const Rigid3 a = random_pose(random, 2.0, 10.0);
    const Rigid3 b = random_pose(random, 2.0, 10.0);
    // At the measurement, where the Jacobian of Log is identity.
    const RelativePose edge{.second = 1, .first_from_second = a.inverse() * b};
    const RelativePoseJacobians j = jacobians_of(a, b);
    for (int p = 0; p < 6; ++p) {
      const PoseVector by_a =
          (residual_of(edge, moved(a, p, kStep), b) - residual_of(edge, moved(a, p, -kStep), b)) /
          (2.0 * kStep);
      const PoseVector by_b =
          (residual_of(edge, a, moved(b, p, kStep)) - residual_of(edge, a, moved(b, p, -kStep))) /
          (2.0 * kStep);
      EXPECT_LT((by_a - j.by_first.col(p)).norm(), 1e-6);
      EXPECT_LT((by_b - j.by_second.col(p)).norm(), 1e-6);
    }
  }
}

TEST(VelocityChange, HasTheGradientOfItsSquare) {
  Random random(2, "test/velocity_change");
  std::vector<Rigid3> poses;
  for (int i = 0; i < 3; ++i) poses.push_back(random_pose(random, 2.0, 3.0));
  const Eigen::Matrix3d root = Eigen::Matrix3d::Random();
  const VelocityChange change{.middle = 1,
                              .before_s = 0.4,
                              .behind_s = 0.6,
                              .in_middle_mps = {0.3, -0.2, 0.1},
                              .information = root * root.transpose()};
  PoseEquations equations(3);
  add_velocity_change(change, poses, equations);
  const auto cost = [&](const std::vector<Rigid3>& at) {
    const Eigen::Vector3d r = residual_of(change, at);
    return 0.5 * r.dot(change.information * r);
  };
  constexpr double kStep = 1e-6;
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (int p = 0; p < 6; ++p) {
      auto plus = poses;
      auto minus = poses;
      plus[i] = moved(poses[i], p, kStep);
      minus[i] = moved(poses[i], p, -kStep);
      // right() holds the negative gradient.
      EXPECT_NEAR(equations.right(i)[p], -(cost(plus) - cost(minus)) / (2.0 * kStep), 1e-4);
    }
  }
}

/// Forty poses round a circle of 20 m; odometry turns a little too far at each step.
struct RoundDrive {
  std::vector<Rigid3> truth = {};
  std::vector<Rigid3> drifted = {};
  PoseGraph graph = {};
};

RoundDrive round_drive() {
  RoundDrive drive;
  constexpr int kPoses = 40;
  for (int i = 0; i <= kPoses; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPoses;
    drive.truth.push_back({.rotation = Eigen::Quaterniond(so3_exp({0.0, 0.0, angle})),
                           .translation = {20.0 * std::sin(angle), -20.0 * std::cos(angle), 0.0}});
  }
  const Rigid3 drift{.rotation = Eigen::Quaterniond(so3_exp({0.0, 0.0, 0.004})),
                     .translation = {0.01, 0.0, 0.02}};
  drive.drifted.push_back(drive.truth[0]);
  for (std::uint32_t i = 0; i < kPoses; ++i) {
    const Rigid3 step = drive.truth[i].inverse() * drive.truth[i + 1] * drift;
    drive.graph.odometry.push_back({.first = i,
                                    .second = i + 1,
                                    .first_from_second = step,
                                    .information = information_of(0.02, 0.004)});
    drive.drifted.push_back(drive.drifted.back() * step);
  }
  for (const Rigid3& pose : drive.drifted) {
    drive.graph.up_in_body.push_back(pose.rotation.conjugate() * Eigen::Vector3d::UnitZ());
  }
  const auto loop = [&](std::uint32_t first, std::uint32_t second) {
    return RelativePose{.first = first,
                        .second = second,
                        .first_from_second = drive.truth[first].inverse() * drive.truth[second],
                        .information = information_of(0.02, 0.002)};
  };
  drive.graph.loops = {loop(0, 38), loop(0, 39), loop(1, 40)};
  return drive;
}

TEST(PoseGraph, ClosesARoundThatDrifted) {
  const RoundDrive drive = round_drive();
  std::vector<Rigid3> poses = drive.drifted;
  EXPECT_GT((poses[40].translation - drive.truth[40].translation).norm(), 0.8);
  const auto report = optimize_pose_graph(drive.graph, 3.0, poses);
  ASSERT_TRUE(report) << report.error().message;
  // Constant drift is not noise: half way round something of it stays.
  EXPECT_THAT(poses[40], Rigid3Near(drive.truth[40], 0.03, 0.01));
  EXPECT_LT((poses[20].translation - drive.truth[20].translation).norm(), 0.5);
  for (const double sigmas : report->loop_sigmas) EXPECT_LT(sigmas, 3.0);
}

TEST(PoseGraph, IsNotTakenInByAWrongLoop) {
  RoundDrive drive = round_drive();
  std::vector<Rigid3> without = drive.drifted;
  ASSERT_TRUE(optimize_pose_graph(drive.graph, 3.0, without));
  drive.graph.loops.push_back({.first = 5,
                               .second = 25,
                               .first_from_second = {.translation = {1.0, 2.0, 0.0}},
                               .information = information_of(0.02, 0.002)});
  std::vector<Rigid3> with = drive.drifted;
  const auto report = optimize_pose_graph(drive.graph, 3.0, with);
  ASSERT_TRUE(report);
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_LT((with[i].translation - without[i].translation).norm(), 0.1) << i;
  }
  EXPECT_GT(report->loop_sigmas.back(), 50.0);
}

TEST(PoseGraph, KeepsTheMapLevel) {
  RoundDrive drive = round_drive();
  // A loop that would tilt the end of the round by two degrees.
  for (RelativePose& loop : drive.graph.loops) {
    loop.first_from_second.rotation =
        loop.first_from_second.rotation * Eigen::Quaterniond(so3_exp({0.035, 0.0, 0.0}));
  }
  std::vector<Rigid3> poses = drive.drifted;
  ASSERT_TRUE(optimize_pose_graph(drive.graph, 3.0, poses));
  for (const Rigid3& pose : poses) {
    EXPECT_GT((pose.rotation * Eigen::Vector3d::UnitZ()).z(), std::cos(0.006));
  }
}

TEST(PoseGraph, FollowsPositionsOnlyAsFarAsTheirDeviationAllows) {
  RoundDrive drive = round_drive();
  drive.graph.loops.clear();
  for (std::uint32_t i = 0; i < drive.truth.size(); ++i) {
    drive.graph.positions.push_back(
        {.pose = i, .point_in_map = drive.truth[i].translation, .sigma_m = 0.3});
  }
  std::vector<Rigid3> near = drive.drifted;
  ASSERT_TRUE(optimize_pose_graph(drive.graph, 3.0, near));
  const double drift_m = (drive.drifted[40].translation - drive.truth[40].translation).norm();
  EXPECT_LT((near[40].translation - drive.truth[40].translation).norm(), 0.5 * drift_m);
  for (PositionPrior& prior : drive.graph.positions) prior.sigma_m = 100.0;
  std::vector<Rigid3> far = drive.drifted;
  ASSERT_TRUE(optimize_pose_graph(drive.graph, 3.0, far));
  EXPECT_LT((far[40].translation - drive.drifted[40].translation).norm(), 0.1);
}

}  // namespace
}  // namespace hybridfusion
