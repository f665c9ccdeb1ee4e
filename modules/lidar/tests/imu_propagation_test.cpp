#include "imu_propagation.hpp"

#include "imu_buffer.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

NavState some_state() {
  NavState state;
  state.map_from_imu = so3_exp({0.2, -0.3, 1.0});
  state.velocity_in_map = {4.0, -1.0, 0.2};
  state.gyro_bias = {0.01, -0.02, 0.005};
  state.accel_bias = {0.1, 0.05, -0.08};
  return state;
}

const ImuStep kStep{.dt_s = 0.02,
                    .angular_velocity_radps = {0.4, -0.5, 1.2},
                    .specific_force_mps2 = {1.0, -2.0, 10.5}};

ImuSample sample(double time_s) {
  return {.time = from_seconds(time_s),
          .angular_velocity_radps = {0.0, 0.0, time_s},
          .specific_force_mps2 = {0.0, 0.0, 9.81}};
}

double total_s(const std::vector<ImuStep>& steps) {
  double sum = 0.0;
  for (const ImuStep& step : steps) sum += step.dt_s;
  return sum;
}

TEST(Propagation, JacobianAgreesWithDifferences) {
  const NavState state = some_state();
  const NavState after = propagated(state, kStep);
  constexpr double kH = 1e-5;
  ErrorMatrix numeric;
  for (int k = 0; k < err::kSize; ++k) {
    const ErrorVector d = kH * ErrorVector::Unit(k);
    numeric.col(k) = (minus(propagated(plus(state, d), kStep), after) -
                      minus(propagated(plus(state, -d), kStep), after)) /
                     (2.0 * kH);
  }
  EXPECT_LT((propagation_jacobian(state, kStep) - numeric).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Propagation, FreeFallFollowsTheParabola) {
  NavState state;
  state.velocity_in_map = {3.0, 0.0, 5.0};
  for (int i = 0; i < 100; ++i) state = propagated(state, {.dt_s = 0.01});
  EXPECT_TRUE(state.position_in_map.isApprox(Eigen::Vector3d(3.0, 0.0, 5.0 - 0.5 * 9.81), 1e-12));
}

TEST(Propagation, BackwardsUndoesForwards) {
  const NavState state = some_state();
  EXPECT_LT(minus(propagated_back(propagated(state, kStep), kStep), state).norm(), 1e-13);
}

TEST(Propagation, NoiseDoesNotDependOnHowTimeIsCut) {
  const ImuNoise noise;
  StateEstimate whole{.state = some_state()};
  StateEstimate parts = whole;
  ImuStep step = kStep;
  step.dt_s = 0.01;
  propagate(step, noise, whole);
  step.dt_s = 0.001;
  for (int i = 0; i < 10; ++i) propagate(step, noise, parts);
  for (const int i : {err::kRotation, err::kVelocity, err::kGyroBias, err::kAccelBias}) {
    EXPECT_NEAR(whole.covariance(i, i) / parts.covariance(i, i), 1.0, 1e-3) << i;
  }
  // Random walk of the attitude: density^2 times duration.
  EXPECT_NEAR(whole.covariance(err::kRotation, err::kRotation),
              noise.gyro_noise_density * noise.gyro_noise_density * 0.01,
              1e-12);
}

TEST(Propagation, PathLeadsToItsEnd) {
  NavState state = some_state();
  const std::vector<ImuStep> steps(5, kStep);
  const NavState start = state;
  for (const ImuStep& step : steps) state = propagated(state, step);
  const auto path = path_before(state, steps);
  ASSERT_EQ(path.size(), 5U);
  EXPECT_NEAR(path.front().time_s, -0.1, 1e-12);
  EXPECT_TRUE(path.front().position_in_map.isApprox(start.position_in_map + Eigen::Vector3d::Zero(),
                                                    1e-9) ||
              (path.front().position_in_map - start.position_in_map).norm() < 1e-12);
  EXPECT_TRUE(path.front().map_from_imu.isApprox(start.map_from_imu, 1e-12));
}

TEST(Propagation, IncrementPredictsLikePropagation) {
  NavState state = some_state();
  const NavState start = state;
  ImuIncrement increment;
  for (int i = 0; i < 10; ++i) {
    state = propagated(state, kStep);
    integrate(kStep, start.gyro_bias, increment);
  }
  const double t = increment.duration_s;
  const Eigen::Vector3d position =
      start.position_in_map + t * start.velocity_in_map + 0.5 * t * t * start.gravity_in_map +
      start.map_from_imu *
          (increment.position_m + increment.position_by_accel_bias * start.accel_bias);
  EXPECT_LT((position - state.position_in_map).norm(), 1e-12);
}

TEST(ImuBuffer, StepsCoverTheIntervalAndAreShort) {
  ImuBuffer buffer;
  for (int i = 0; i <= 20; ++i) buffer.add(sample(1.0 + 0.005 * i));
  const auto steps = buffer.steps(from_seconds(1.0123), from_seconds(1.0801));
  EXPECT_NEAR(total_s(steps), 0.0678, 1e-9);
  for (const ImuStep& step : steps) EXPECT_FALSE(step.bridged);
  // Mid-point of interpolated samples: the rate is its time by construction.
  EXPECT_NEAR(steps.front().angular_velocity_radps.z(), 1.0123 + 0.5 * steps.front().dt_s, 1e-9);
}

TEST(ImuBuffer, BridgesGapsAndHoldsBeyondTheData) {
  ImuBuffer buffer;
  for (int i = 0; i <= 20; ++i) buffer.add(sample(1.0 + 0.005 * i));
  buffer.add(sample(1.9));
  EXPECT_EQ(buffer.num_gaps(), 1U);
  const auto gap = buffer.steps(from_seconds(1.2), from_seconds(1.3));
  EXPECT_NEAR(total_s(gap), 0.1, 1e-9);
  EXPECT_TRUE(gap.front().bridged);
  EXPECT_FALSE(gap.front().held);
  const auto beyond = buffer.steps(from_seconds(2.0), from_seconds(2.2));
  EXPECT_NEAR(total_s(beyond), 0.2, 1e-9);
  EXPECT_TRUE(beyond.back().held);
  const auto before = buffer.steps(from_seconds(0.5), from_seconds(0.7));
  EXPECT_NEAR(total_s(before), 0.2, 1e-9);
  EXPECT_TRUE(before.front().held);
}

TEST(ImuBuffer, DropsWhatIsNotFiniteOrRepeats) {
  ImuBuffer buffer;
  using Verdict = ImuBuffer::Verdict;
  EXPECT_EQ(buffer.add(sample(1.0)), Verdict::kTaken);
  EXPECT_EQ(buffer.add(sample(1.0)), Verdict::kDropped);
  ImuSample bad = sample(1.01);
  bad.specific_force_mps2.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(buffer.add(bad), Verdict::kDropped);
  EXPECT_EQ(buffer.add(sample(50.0)), Verdict::kHeld);
  EXPECT_EQ(buffer.add(sample(1.01)), Verdict::kTaken);  // the far one was a wrong stamp
  EXPECT_EQ(buffer.last_time(), from_seconds(1.01));
}

}  // namespace
}  // namespace hybridfusion
