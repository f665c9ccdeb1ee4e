#include "rigid3_matchers.hpp"

#include <hybridfusion/core/trajectory.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::Rigid3Near;

Rigid3 yaw_and_x(double yaw_rad, double x_m) {
  return {.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())),
          .translation = {x_m, 0.0, 0.0}};
}

TEST(Interpolate, IsHalfWayBetweenTwoPoses) {
  const Trajectory trajectory{.poses = {{from_seconds(10.0), yaw_and_x(0.0, 0.0)},
                                        {from_seconds(11.0), yaw_and_x(0.2, 4.0)}}};
  const auto pose = interpolate(trajectory, from_seconds(10.5), 0.0);
  ASSERT_TRUE(pose);
  EXPECT_THAT(*pose, Rigid3Near(yaw_and_x(0.1, 2.0), 1e-9, 1e-9));
}

TEST(Interpolate, HoldsTheEndsAndRefusesBeyond) {
  const Trajectory trajectory{.poses = {{from_seconds(10.0), yaw_and_x(0.0, 1.0)}}};
  EXPECT_TRUE(interpolate(trajectory, from_seconds(10.05), 0.1));
  EXPECT_EQ(interpolate(trajectory, from_seconds(10.2), 0.1).error().code,
            ErrorCode::kInsufficient);
  EXPECT_FALSE(interpolate({}, from_seconds(1.0), 1e9));
}

}  // namespace
}  // namespace hybridfusion
