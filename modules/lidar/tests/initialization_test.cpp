#include "initialization.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

ImuMean mean_at_rest(const Eigen::Vector3d& accel_bias) {
  return {.num_samples = 200,
          .duration_s = 1.0,
          .angular_velocity_radps = {0.002, -0.001, 0.003},
          .specific_force_mps2 = Eigen::Vector3d(0.4, -0.2, 9.8) + accel_bias,
          .gyro_std_radps = 0.003,
          .accel_std_mps2 = 0.02};
}

TEST(StandstillState, PredictsNoAccelerationAtRest) {
  const ImuMean mean = mean_at_rest({0.05, 0.03, -0.04});
  const StateEstimate start = standstill_state(mean, {}, 0.02);
  const NavState& state = start.state;
  const Eigen::Vector3d acceleration =
      state.map_from_imu * (mean.specific_force_mps2 - state.accel_bias) + state.gravity_in_map;
  EXPECT_LT(acceleration.norm(), 2e-3);
  EXPECT_EQ(state.gyro_bias, mean.angular_velocity_radps);
}

TEST(StandstillState, KnowsTheSumOfBiasAndGravityButNotTheParts) {
  const LidarRig rig{.imu_noise = {.gyro_noise_density = 2e-4, .accel_noise_density = 2e-3}};
  const StateEstimate start = standstill_state(mean_at_rest(Eigen::Vector3d::Zero()), rig, 0.02);
  Eigen::Matrix<double, 3, err::kSize> sum = Eigen::Matrix<double, 3, err::kSize>::Zero();
  sum.block<3, 3>(0, err::kAccelBias).setIdentity();
  sum.block<3, 2>(0, err::kGravity) =
      -start.state.map_from_imu.transpose() *
      s2_plus_jacobian(start.state.gravity_in_map, Eigen::Vector2d::Zero());
  const Eigen::Matrix3d spread = sum * start.covariance * sum.transpose();
  EXPECT_LT(std::sqrt(spread.diagonal().maxCoeff()), 0.01);  // 3e-3 + 2 * 2e-3
  EXPECT_GT(std::sqrt(start.covariance(err::kAccelBias, err::kAccelBias)), 0.05);
  EXPECT_GT(std::sqrt(start.covariance(err::kGravity, err::kGravity)), 0.005);
}

TEST(IsStandstill, LooseDensitiesDoNotMakeADriveOne) {
  ImuMean driving = mean_at_rest(Eigen::Vector3d::Zero());
  driving.accel_std_mps2 = 1.0;
  const ImuNoise loose{.gyro_noise_density = 0.05, .accel_noise_density = 3.0};
  EXPECT_FALSE(is_standstill(driving, {}, loose));
  EXPECT_TRUE(is_standstill(mean_at_rest(Eigen::Vector3d::Zero()), {}, {}));
}

}  // namespace
}  // namespace hybridfusion
