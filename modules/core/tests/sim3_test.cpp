#include "rigid3_matchers.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Eigen::Vector3d random_point(Random& random) {
  return {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-5, 5)};
}

Sim3 example_sim3() {
  return {.rotation = Eigen::Quaterniond(0.3, -0.2, 0.9, 0.1).normalized(),
          .translation = {3.0, -7.0, 11.0},
          .scale = 1.7};
}

TEST(Sim3, InverseUndoesIt) {
  const Eigen::Vector3d p(1.0, 2.0, 3.0);
  const Sim3 target_from_source = example_sim3();
  EXPECT_TRUE((target_from_source.inverse() * (target_from_source * p)).isApprox(p, 1e-12));
  EXPECT_TRUE(((target_from_source.inverse() * target_from_source) * p).isApprox(p, 1e-12));
}

TEST(FitSim3, RecoversTheTransformThatMadeThePoints) {
  Random random(1, "sim3_test");
  const Sim3 truth = example_sim3();
  std::vector<Eigen::Vector3d> source(20);
  std::vector<Eigen::Vector3d> target(20);
  for (std::size_t i = 0; i < source.size(); ++i) {
    source[i] = random_point(random);
    target[i] = truth * source[i];
  }
  const auto fitted = fit_sim3(target, source);
  ASSERT_TRUE(fitted) << fitted.error().message;
  EXPECT_NEAR(fitted->scale, truth.scale, 1e-12);
  EXPECT_TRUE((*fitted * source[3]).isApprox(target[3], 1e-12));
}

TEST(FitSim3, AZeroWeightRemovesAPair) {
  Random random(2, "sim3_test");
  std::vector<Eigen::Vector3d> points(10);
  for (auto& p : points) p = random_point(random);
  std::vector<Eigen::Vector3d> target = points;
  target[4] += Eigen::Vector3d(100, 0, 0);
  std::vector<double> weights(points.size(), 1.0);
  weights[4] = 0.0;
  const auto fitted = fit_rigid3(target, points, weights);
  ASSERT_TRUE(fitted);
  EXPECT_THAT(*fitted, Rigid3Near(Rigid3{}, 1e-10, 1e-10));
}

TEST(FitSim3, AMirroredCloudStillGivesARotation) {
  Random random(3, "sim3_test");
  std::vector<Eigen::Vector3d> source(10);
  for (auto& p : source) p = random_point(random);
  std::vector<Eigen::Vector3d> target = source;
  for (auto& p : target) p.x() = -p.x();
  const auto fitted = fit_rigid3(target, source);
  ASSERT_TRUE(fitted);
  EXPECT_NEAR(fitted->rotation.toRotationMatrix().determinant(), 1.0, 1e-12);
}

TEST(FitSim3, CollinearPointsAreDegenerate) {
  const std::vector<Eigen::Vector3d> line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}};
  EXPECT_EQ(fit_sim3(line, line).error().code, ErrorCode::kDegenerate);
}

TEST(FitSim3, TwoPairsAreInsufficient) {
  const std::vector<Eigen::Vector3d> two = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(fit_sim3(two, two).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
