#include "imu_propagation.hpp"

namespace hybridfusion {
namespace {

// What a bridged interval may hide: 0.3 rad/s and 3 m/s^2 of unseen motion with half a second of
// memory, as densities.
constexpr double kBridgedGyroDensity = 0.2;   // rad/s/sqrt(Hz)
constexpr double kBridgedAccelDensity = 2.0;  // m/s^2/sqrt(Hz)

struct MidPoint {
  Eigen::Vector3d rate;           // angular velocity without bias
  Eigen::Vector3d force;          // specific force without bias
  Eigen::Matrix3d half_rotation;  // Exp(rate dt / 2)

  [[nodiscard]] Eigen::Vector3d acceleration_in_map(const NavState& state,
                                                    const ImuStep& step,
                                                    const Eigen::Matrix3d& map_from_mid) const {
    if (step.coasting) return Eigen::Vector3d::Zero();
    return map_from_mid * force + state.gravity_in_map;
  }
};

MidPoint mid_point(const NavState& state, const ImuStep& step) {
  MidPoint mid;
  mid.rate = step.angular_velocity_radps - state.gyro_bias;
  mid.force = step.specific_force_mps2 - state.accel_bias;
  mid.half_rotation = so3_exp(0.5 * step.dt_s * mid.rate);
  return mid;
}

}  // namespace

NavState propagated(const NavState& state, const ImuStep& step) {
  const double dt = step.dt_s;
  const MidPoint mid = mid_point(state, step);
  const Eigen::Matrix3d map_from_mid = state.map_from_imu * mid.half_rotation;
  const Eigen::Vector3d acceleration = mid.acceleration_in_map(state, step, map_from_mid);
  NavState out = state;
  out.position_in_map += state.velocity_in_map * dt + 0.5 * dt * dt * acceleration;
  out.velocity_in_map += dt * acceleration;
  out.map_from_imu = map_from_mid * mid.half_rotation;
  return out;
}

NavState propagated_back(const NavState& state, const ImuStep& step) {
  const double dt = step.dt_s;
  const MidPoint mid = mid_point(state, step);
  const Eigen::Matrix3d map_from_mid = state.map_from_imu * mid.half_rotation.transpose();
  const Eigen::Vector3d acceleration = mid.acceleration_in_map(state, step, map_from_mid);
  NavState out = state;
  out.map_from_imu = map_from_mid * mid.half_rotation.transpose();
  out.velocity_in_map -= dt * acceleration;
  out.position_in_map -= out.velocity_in_map * dt + 0.5 * dt * dt * acceleration;
  return out;
}

ErrorMatrix propagation_jacobian(const NavState& state, const ImuStep& step) {
  const double dt = step.dt_s;
  const MidPoint mid = mid_point(state, step);
  const Eigen::Vector3d half_angle = 0.5 * dt * mid.rate;
  const Eigen::Matrix3d map_from_mid = state.map_from_imu * mid.half_rotation;
  const Eigen::Matrix3d force_lever = map_from_mid * skew(mid.force);

  ErrorMatrix f = ErrorMatrix::Identity();
  // d(acceleration)/d(theta, b_g, b_a, g); velocity takes dt of it, position 1/2 dt^2.
  Eigen::Matrix<double, 3, err::kSize> da = Eigen::Matrix<double, 3, err::kSize>::Zero();
  da.block<3, 3>(0, err::kAccelBias) = -map_from_mid;  // while coasting: of its noise alone
  if (!step.coasting) {
    da.block<3, 3>(0, err::kRotation) = -force_lever * mid.half_rotation.transpose();
    da.block<3, 3>(0, err::kGyroBias) = force_lever * so3_right_jacobian(half_angle) * (0.5 * dt);
    da.block<3, 2>(0, err::kGravity) =
        s2_plus_jacobian(state.gravity_in_map, Eigen::Vector2d::Zero());
  }
  f.middleRows<3>(err::kPosition) += 0.5 * dt * dt * da;
  f.block<3, 3>(err::kPosition, err::kVelocity) += dt * Eigen::Matrix3d::Identity();
  f.middleRows<3>(err::kVelocity) += dt * da;
  f.block<3, 3>(err::kRotation, err::kRotation) =
      (mid.half_rotation * mid.half_rotation).transpose();
  f.block<3, 3>(err::kRotation, err::kGyroBias) = -dt * so3_right_jacobian(dt * mid.rate);
  return f;
}

void propagate(const ImuStep& step, const ImuNoise& noise, StateEstimate& estimate) {
  const double dt = step.dt_s;
  if (dt <= 0.0) return;
  const ErrorMatrix f = propagation_jacobian(estimate.state, step);
  double gyro = noise.gyro_noise_density;
  double accel = noise.accel_noise_density;
  if (step.bridged && !step.coasting) gyro = kBridgedGyroDensity, accel = kBridgedAccelDensity;

  ErrorMatrix p = f * estimate.covariance * f.transpose();
  // White noise acts where the biases act: columns of F at the biases, variance density^2 / dt.
  const auto gyro_columns = f.block<9, 3>(0, err::kGyroBias);
  const auto accel_columns = f.block<9, 3>(0, err::kAccelBias);
  p.topLeftCorner<9, 9>() += gyro * gyro / dt * gyro_columns * gyro_columns.transpose() +
                             accel * accel / dt * accel_columns * accel_columns.transpose();
  for (int i = 0; i < 3; ++i) {
    p(err::kGyroBias + i, err::kGyroBias + i) += noise.gyro_bias_walk * noise.gyro_bias_walk * dt;
    p(err::kAccelBias + i, err::kAccelBias + i) +=
        noise.accel_bias_walk * noise.accel_bias_walk * dt;
  }
  estimate.covariance = 0.5 * (p + p.transpose());
  estimate.state = propagated(estimate.state, step);
}

void integrate(const ImuStep& step, const Eigen::Vector3d& gyro_bias, ImuIncrement& increment) {
  const double dt = step.dt_s;
  const Eigen::Matrix3d half = so3_exp(0.5 * dt * (step.angular_velocity_radps - gyro_bias));
  const Eigen::Matrix3d mid = increment.rotation * half;
  const Eigen::Vector3d force = mid * step.specific_force_mps2;
  increment.position_m += dt * increment.velocity_mps + 0.5 * dt * dt * force;
  increment.position_by_accel_bias += dt * increment.velocity_by_accel_bias - 0.5 * dt * dt * mid;
  increment.velocity_mps += dt * force;
  increment.velocity_by_accel_bias -= dt * mid;
  increment.rotation = mid * half;
  increment.duration_s += dt;
  increment.bridged = increment.bridged || step.bridged;
}

std::vector<PathNode> path_before(const NavState& end, std::span<const ImuStep> steps) {
  std::vector<PathNode> path(steps.size());
  NavState state = end;
  double time_s = 0.0;
  for (std::size_t i = steps.size(); i-- > 0;) {
    const ImuStep& step = steps[i];
    const Eigen::Vector3d velocity_after = state.velocity_in_map;
    state = propagated_back(state, step);
    time_s -= step.dt_s;
    path[i] = {.time_s = time_s,
               .map_from_imu = state.map_from_imu,
               .position_in_map = state.position_in_map,
               .velocity_in_map = state.velocity_in_map,
               .acceleration_in_map = (velocity_after - state.velocity_in_map) / step.dt_s,
               .angular_velocity_radps = step.angular_velocity_radps - state.gyro_bias};
  }
  return path;
}

}  // namespace hybridfusion
