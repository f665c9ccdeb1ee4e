#include "adjustment_costs.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Pose = std::array<double, kPoseSize>;

Pose some_pose() {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.1, 0.9, -0.3, 0.2).normalized();
  return {q.x(), q.y(), q.z(), q.w(), 3.0, -4.0, 60.0};
}

/// Compares a pose block's Jacobian with differences along its tangent.
void expect_pose_jacobian(const ceres::CostFunction& cost,
                          std::vector<double*> blocks,
                          std::size_t block,
                          double tolerance) {
  const int rows = cost.num_residuals();
  Eigen::MatrixXd analytic(rows, kPoseSize);
  Eigen::Matrix<double, Eigen::Dynamic, kPoseSize, Eigen::RowMajor> storage(rows, kPoseSize);
  std::vector<double*> jacobians(blocks.size(), nullptr);
  jacobians[block] = storage.data();
  Eigen::VectorXd residuals(rows);
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residuals.data(), jacobians.data()));
  const PoseManifold manifold;
  Pose start;
  std::copy_n(blocks[block], kPoseSize, start.begin());
  constexpr double kStep = 1e-6;
  for (int k = 0; k < kPoseTangent; ++k) {
    Eigen::Matrix<double, kPoseTangent, 1> delta = kStep * Eigen::Matrix<double, 6, 1>::Unit(k);
    Eigen::VectorXd plus(rows);
    Eigen::VectorXd minus(rows);
    Pose moved;
    manifold.Plus(start.data(), delta.data(), moved.data());
    blocks[block] = moved.data();
    ASSERT_TRUE(cost.Evaluate(blocks.data(), plus.data(), nullptr));
    delta = -delta;
    manifold.Plus(start.data(), delta.data(), moved.data());
    ASSERT_TRUE(cost.Evaluate(blocks.data(), minus.data(), nullptr));
    EXPECT_LT(((plus - minus) / (2.0 * kStep) - storage.col(k)).norm(), tolerance) << k;
  }
  EXPECT_EQ(storage.col(6).norm(), 0.0);
}

TEST(AdjustmentCosts, ReprojectionJacobiansEqualDifferences) {
  const ReprojectionCost cost({700.0, 500.0}, 0.5);
  Pose pose = some_pose();
  const Eigen::Map<const Eigen::Quaterniond> rotation(pose.data());
  // 60 m in front of the camera.
  Eigen::Vector3d point = rotation * Eigen::Vector3d(8.0, -5.0, 60.0) + Eigen::Vector3d(3, -4, 60);
  IntrinsicsVector intrinsics;
  intrinsics << 1290.0, 801.0, 597.0, -0.05, 0.02, 0.0, 0.001, -0.001;
  const std::vector<double*> blocks{pose.data(), point.data(), intrinsics.data()};
  expect_pose_jacobian(cost, blocks, 0, 1e-3);

  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> by_point;
  std::vector<double*> jacobians{nullptr, by_point.data(), nullptr};
  Eigen::Vector2d residual;
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residual.data(), jacobians.data()));
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector2d plus;
    Eigen::Vector2d minus;
    point[k] += kStep;
    ASSERT_TRUE(cost.Evaluate(blocks.data(), plus.data(), nullptr));
    point[k] -= 2.0 * kStep;
    ASSERT_TRUE(cost.Evaluate(blocks.data(), minus.data(), nullptr));
    point[k] += kStep;
    EXPECT_LT(((plus - minus) / (2.0 * kStep) - by_point.col(k)).norm(), 1e-4);
  }
}

TEST(AdjustmentCosts, PointBehindTheCameraIsRefused) {
  const ReprojectionCost cost({700.0, 500.0}, 0.5);
  Pose pose = some_pose();
  const Eigen::Map<const Eigen::Quaterniond> rotation(pose.data());
  Eigen::Vector3d point = rotation * Eigen::Vector3d(0.0, 0.0, -5.0) + Eigen::Vector3d(3, -4, 60);
  IntrinsicsVector intrinsics;
  intrinsics << 1290.0, 801.0, 597.0, 0.0, 0.0, 0.0, 0.0, 0.0;
  const std::vector<double*> blocks{pose.data(), point.data(), intrinsics.data()};
  Eigen::Vector2d residual;
  EXPECT_FALSE(cost.Evaluate(blocks.data(), residual.data(), nullptr));
}

TEST(AdjustmentCosts, TagErrorJacobianEqualsDifferences) {
  const GnssPositionCost cost({.position = {1.0, -4.0, 50.0},
                               .sigma_m = {2.0, 2.0, 5.0},
                               .time_s = 10.0,
                               .velocity_mps = {4.0, -2.0, 0.5}});
  Pose pose = some_pose();
  Eigen::Vector3d errors(1.0, 0.1, 0.5);
  const std::array<double*, 2> blocks{pose.data(), errors.data()};
  Eigen::Matrix<double, 3, kNumTagErrors, Eigen::RowMajor> analytic;
  std::array<double*, 2> jacobians{nullptr, analytic.data()};
  Eigen::Vector3d residual;
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residual.data(), jacobians.data()));
  constexpr double kStep = 1e-5;
  for (int k = 0; k < kNumTagErrors; ++k) {
    Eigen::Vector3d plus;
    Eigen::Vector3d minus;
    errors[k] += kStep;
    ASSERT_TRUE(cost.Evaluate(blocks.data(), plus.data(), nullptr));
    errors[k] -= 2.0 * kStep;
    ASSERT_TRUE(cost.Evaluate(blocks.data(), minus.data(), nullptr));
    errors[k] += kStep;
    EXPECT_LT(((plus - minus) / (2.0 * kStep) - analytic.col(k)).norm(), 1e-6) << k;
  }
}

TEST(AdjustmentCosts, GnssPositionIsTheDifferenceOverSigmaWithTheTagErrorsAdded) {
  const GnssPositionCost cost({.position = {1.0, -4.0, 50.0},
                               .sigma_m = {2.0, 2.0, 5.0},
                               .time_s = 10.0,
                               .velocity_mps = {4.0, -2.0, 0.0}});
  Pose pose = some_pose();
  Eigen::Vector3d errors(1.0, 0.1, 0.5);
  const std::vector<double*> blocks{pose.data(), errors.data()};
  Eigen::Vector3d residual;
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residual.data(), nullptr));
  // (3 - 0.5 * 4 - 1) / 2, (-4 + 0.5 * 2 + 4) / 2, (60 + 1 + 0.1 * 10 - 50) / 5
  EXPECT_LT((residual - Eigen::Vector3d(0.0, 0.5, 2.4)).norm(), 1e-12);
  expect_pose_jacobian(cost, blocks, 0, 1e-6);
}

TEST(AdjustmentCosts, AntennaBesideTheCameraTurnsWithIt) {
  const Eigen::Vector3d lever(0.3, -0.1, -0.4);
  Pose pose = some_pose();
  const Eigen::Map<const Eigen::Quaterniond> rotation(pose.data());
  const Eigen::Vector3d antenna = Eigen::Vector3d(3, -4, 60) + rotation * lever;
  const GnssPositionCost position(
      {.position = antenna, .sigma_m = {0.02, 0.02, 0.04}, .antenna_in_camera = lever});
  Eigen::Vector3d errors = Eigen::Vector3d::Zero();
  const std::vector<double*> blocks{pose.data(), errors.data()};
  Eigen::Vector3d residual;
  ASSERT_TRUE(position.Evaluate(blocks.data(), residual.data(), nullptr));
  EXPECT_LT(residual.norm(), 1e-9);
  expect_pose_jacobian(position, blocks, 0, 1e-5);

  const GnssDisplacementCost displacement({10.0, 0.0, 0.0}, {0.5, 0.5, 1.0}, lever);
  Pose after = some_pose();
  after[4] += 10.5;
  const Eigen::Matrix<double, 6, 1> turn{0.0, 0.0, 0.0, 0.2, -0.1, 0.3};
  Pose turned;
  PoseManifold().Plus(after.data(), turn.data(), turned.data());
  const std::vector<double*> poses{pose.data(), turned.data()};
  expect_pose_jacobian(displacement, poses, 0, 1e-6);
  expect_pose_jacobian(displacement, poses, 1, 1e-6);
}

TEST(AdjustmentCosts, UpDirectionIsItsHorizontalPartOverSigma) {
  Pose pose = some_pose();
  const Eigen::Map<const Eigen::Quaterniond> rotation(pose.data());
  const Eigen::Vector3d up = Eigen::Vector3d(0.01, -0.02, 1.0).normalized();
  const UpDirectionCost cost(rotation.conjugate() * up, 0.01);
  const std::vector<double*> blocks{pose.data()};
  Eigen::Vector2d residual;
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residual.data(), nullptr));
  EXPECT_LT((residual - up.head<2>() / 0.01).norm(), 1e-9);
  expect_pose_jacobian(cost, blocks, 0, 1e-6);
}

TEST(AdjustmentCosts, GnssDisplacementIsBlindToACommonOffset) {
  const GnssDisplacementCost cost({10.0, 0.0, 0.0}, {0.5, 0.5, 1.0}, Eigen::Vector3d::Zero());
  Pose before = some_pose();
  Pose after = some_pose();
  after[4] += 10.5;
  const std::vector<double*> blocks{before.data(), after.data()};
  Eigen::Vector3d residual;
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residual.data(), nullptr));
  EXPECT_LT((residual - Eigen::Vector3d(1.0, 0.0, 0.0)).norm(), 1e-12);
  for (const double shift : {7.0, -100.0}) {
    before[5] += shift;
    after[5] += shift;
    Eigen::Vector3d shifted;
    ASSERT_TRUE(cost.Evaluate(blocks.data(), shifted.data(), nullptr));
    EXPECT_LT((shifted - residual).norm(), 1e-12);
  }
  expect_pose_jacobian(cost, blocks, 0, 1e-6);
  expect_pose_jacobian(cost, blocks, 1, 1e-6);
}

TEST(AdjustmentCosts, MinusUndoesPlusOnThePoseManifold) {
  const PoseManifold manifold;
  const Pose x = some_pose();
  const Eigen::Matrix<double, 6, 1> delta{0.4, -2.0, 1.0, 0.1, -0.2, 0.05};
  Pose y;
  Eigen::Matrix<double, 6, 1> back;
  manifold.Plus(x.data(), delta.data(), y.data());
  manifold.Minus(y.data(), x.data(), back.data());
  EXPECT_LT((back - delta).norm(), 1e-12);
}

}  // namespace
}  // namespace hybridfusion
