#include "rigid3_matchers.hpp"

#include <hybridfusion/registration/pose_clustering.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Rigid3 yaw_and_x(double yaw_rad, double x_m) {
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())),
          .translation = {x_m, 0.0, 0.0}};
}

TEST(LargestPoseCluster, DropsOutliersAndAveragesTheRest) {
  const std::vector<Rigid3> poses = {
      yaw_and_x(0.00, 1.0), yaw_and_x(3.0, 50.0), yaw_and_x(0.02, 1.2)};
  const auto cluster = largest_pose_cluster(poses, /*radius_m=*/1.0, /*angle_rad=*/0.1);
  ASSERT_TRUE(cluster) << cluster.error().message;
  EXPECT_EQ(cluster->members, (std::vector<std::size_t>{0, 2}));
  EXPECT_THAT(cluster->mean, Rigid3Near(yaw_and_x(0.01, 1.1), 1e-12, 1e-12));
}

TEST(LargestPoseCluster, BothDistanceAndAngleMustAgree) {
  const std::vector<Rigid3> poses = {yaw_and_x(0.0, 0.0), yaw_and_x(0.5, 0.0), yaw_and_x(0.0, 3.0)};
  const auto cluster = largest_pose_cluster(poses, 1.0, 0.1);
  ASSERT_TRUE(cluster);
  EXPECT_EQ(cluster->members, (std::vector<std::size_t>{0}));
}

TEST(LargestPoseCluster, AChainOfPosesIsNotOneCluster) {
  const std::vector<Rigid3> poses = {yaw_and_x(0.0, 0.0), yaw_and_x(0.0, 0.9), yaw_and_x(0.0, 1.8)};
  const auto cluster = largest_pose_cluster(poses, 1.0, 0.1);
  ASSERT_TRUE(cluster);
  EXPECT_EQ(cluster->members, (std::vector<std::size_t>{0, 1}));
}

TEST(LargestPoseCluster, TheSignOfAQuaternionDoesNotMatter) {
  Rigid3 flipped = yaw_and_x(0.02, 1.2);
  flipped.rotation.coeffs() *= -1.0;
  const std::vector<Rigid3> poses = {yaw_and_x(0.0, 1.0), flipped};
  const auto cluster = largest_pose_cluster(poses, 1.0, 0.1);
  ASSERT_TRUE(cluster);
  EXPECT_THAT(cluster->mean, Rigid3Near(yaw_and_x(0.01, 1.1), 1e-12, 1e-12));
}

TEST(LargestPoseCluster, EmptyInputIsAnErrorNotAnIdentityPose) {
  const auto cluster = largest_pose_cluster({}, 1.0, 0.1);
  ASSERT_FALSE(cluster);
  EXPECT_EQ(cluster.error().code, ErrorCode::kInsufficient);
}

TEST(LargestPoseCluster, NonFinitePosesNeverCount) {
  const std::vector<Rigid3> poses = {yaw_and_x(0.0, std::numeric_limits<double>::quiet_NaN())};
  EXPECT_EQ(largest_pose_cluster(poses, 1.0, 0.1).error().code, ErrorCode::kDegenerate);
}

TEST(LargestPoseCluster, RejectsNonPositiveRadius) {
  const std::vector<Rigid3> poses(2);
  EXPECT_THROW((void)largest_pose_cluster(poses, 0.0, 0.1), std::logic_error);
}

}  // namespace
}  // namespace hybridfusion
