#include "initialization.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr double kGravity_mps2 = 9.81;

void set_variance(StateEstimate& estimate, int at, int size, double sigma) {
  estimate.covariance.diagonal().segment(at, size).setConstant(sigma * sigma);
}

Eigen::Matrix3d level_rotation(const Eigen::Vector3d& up_in_imu) {
  // The rotation with the z axis up that keeps the heading of the IMU's x axis at zero.
  const Eigen::Vector3d up = up_in_imu.normalized();
  Eigen::Vector3d forward = Eigen::Vector3d::UnitX() - up.x() * up;
  if (forward.norm() < 1e-3) forward = Eigen::Vector3d::UnitY() - up.y() * up;
  forward.normalize();
  Eigen::Matrix3d map_from_imu;
  map_from_imu << forward.transpose(), up.cross(forward).transpose(), up.transpose();
  return map_from_imu;
}

StateEstimate common_state(const LidarRig& rig, const Eigen::Vector3d& up_in_imu) {
  StateEstimate out;
  out.state.map_from_imu = level_rotation(up_in_imu);
  out.state.gravity_in_map = {0.0, 0.0, -kGravity_mps2};
  out.state.imu_from_lidar = rig.imu_from_lidar.rotation.toRotationMatrix();
  out.state.lidar_in_imu = rig.imu_from_lidar.translation;
  // Position and attitude define the map, so they are certain; gravity is what is uncertain.
  set_variance(out, err::kPosition, 6, 1e-6);
  return out;
}

}  // namespace

ImuMean imu_mean(const ImuBuffer& imu, Timestamp begin, Timestamp end) {
  ImuMean mean;
  Timestamp first{};
  Eigen::Vector3d gyro2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d accel2 = Eigen::Vector3d::Zero();
  const auto inside = [&](const ImuSample& s) { return s.time >= begin && s.time <= end; };
  for (const ImuSample& sample : imu.samples()) {
    if (!inside(sample)) continue;
    if (mean.num_samples++ == 0) first = sample.time;
    mean.duration_s = to_seconds(sample.time - first);
    mean.angular_velocity_radps += sample.angular_velocity_radps;
    mean.specific_force_mps2 += sample.specific_force_mps2;
  }
  if (mean.num_samples == 0) return mean;
  const auto count = static_cast<double>(mean.num_samples);
  mean.angular_velocity_radps /= count;
  mean.specific_force_mps2 /= count;
  for (const ImuSample& sample : imu.samples()) {
    if (!inside(sample)) continue;
    gyro2 += (sample.angular_velocity_radps - mean.angular_velocity_radps).cwiseAbs2();
    accel2 += (sample.specific_force_mps2 - mean.specific_force_mps2).cwiseAbs2();
  }
  mean.gyro_std_radps = std::sqrt(gyro2.maxCoeff() / count);
  mean.accel_std_mps2 = std::sqrt(accel2.maxCoeff() / count);
  return mean;
}

bool speaks_in_g(const ImuMean& mean) {
  const double norm = mean.specific_force_mps2.norm();
  return norm > 0.5 && norm < 2.0;
}

bool is_standstill(const ImuMean& mean, const LidarInitOptions& options, const ImuNoise& noise) {
  if (mean.num_samples < 10) return false;
  // White noise of a density seen at the sample rate; the rate cannot exceed a few hundred hertz.
  constexpr double kSqrtHalfRate = 15.0;
  // Densities may be set high to trust the IMU less; what moves more than this does not stand.
  constexpr double kNoisiestGyro_radps = 0.05;
  constexpr double kNoisiestAccel_mps2 = 0.8;
  const double gyro_noise = 3.0 * kSqrtHalfRate * noise.gyro_noise_density;
  const double accel_noise = 3.0 * kSqrtHalfRate * noise.accel_noise_density;
  const double max_gyro =
      std::max(options.max_gyro_std_radps, std::min(gyro_noise, kNoisiestGyro_radps));
  const double max_accel =
      std::max(options.max_accel_std_mps2, std::min(accel_noise, kNoisiestAccel_mps2));
  constexpr double kMaxBias_radps = 0.1;
  return mean.gyro_std_radps <= max_gyro && mean.accel_std_mps2 <= max_accel &&
         mean.angular_velocity_radps.norm() <= kMaxBias_radps;
}

StateEstimate standstill_state(const ImuMean& mean,
                               const LidarRig& rig,
                               double velocity_sigma_mps) {
  StateEstimate out = common_state(rig, mean.specific_force_mps2);
  out.state.gyro_bias = mean.angular_velocity_radps;
  // White noise over the window; twice that and a little more for engines and people getting in.
  const double root_s = std::sqrt(std::max(mean.duration_s, 0.1));
  const double rate_sigma = 1e-4 + 2.0 * rig.imu_noise.gyro_noise_density / root_s;
  const double force_sigma = 3e-3 + 2.0 * rig.imu_noise.accel_noise_density / root_s;
  set_variance(out, err::kVelocity, 3, velocity_sigma_mps);
  set_variance(out, err::kGyroBias, 3, rate_sigma);
  set_variance(out, err::kAccelBias, 3, 0.1);
  set_variance(out, err::kGravity, 2, 0.015);
  // At rest the mean force is b_a - R^T g: one update of the prior with it.
  using ForceRows = Eigen::Matrix<double, 3, err::kSize>;
  const Eigen::Matrix3d imu_from_map = out.state.map_from_imu.transpose();
  ForceRows h = ForceRows::Zero();
  h.block<3, 3>(0, err::kAccelBias).setIdentity();
  h.block<3, 2>(0, err::kGravity) =
      -imu_from_map * s2_plus_jacobian(out.state.gravity_in_map, Eigen::Vector2d::Zero());
  const Eigen::Vector3d innovation =
      mean.specific_force_mps2 - out.state.accel_bias + imu_from_map * out.state.gravity_in_map;
  const Eigen::Matrix3d spread =
      h * out.covariance * h.transpose() + force_sigma * force_sigma * Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, err::kSize, 3> gain =
      out.covariance * h.transpose() * spread.inverse();
  const ErrorVector change = gain * innovation;
  const ErrorMatrix j = transport(out.state, change);
  const ErrorMatrix reduced = j * (out.covariance - gain * h * out.covariance) * j.transpose();
  out.state = plus(out.state, change);
  out.covariance = 0.5 * (reduced + reduced.transpose());
  return out;
}

StateEstimate moving_state(const ImuMean& mean, const LidarRig& rig) {
  StateEstimate out = common_state(rig, mean.specific_force_mps2);
  set_variance(out, err::kVelocity, 3, 10.0);
  set_variance(out, err::kGyroBias, 3, 0.02);
  set_variance(out, err::kAccelBias, 3, 0.1);
  set_variance(out, err::kGravity, 2, 0.1);
  return out;
}

std::optional<StateEstimate> fit_moving_state(const StateEstimate& start,
                                              Timestamp begin,
                                              std::span<const ScanEstimate> scans,
                                              const ImuBuffer& imu) {
  constexpr std::size_t kMinScans = 5;
  if (scans.size() < kMinScans) return std::nullopt;
  // p(t) = p0 + v0 t + 1/2 g t^2 + integral of the specific force turned into the map.
  using Matrix9 = Eigen::Matrix<double, 9, 9>;
  Matrix9 normal = Matrix9::Zero();
  Eigen::Matrix<double, 9, 1> right = Eigen::Matrix<double, 9, 1>::Zero();
  NavState integrated = start.state;
  integrated.position_in_map.setZero();
  integrated.velocity_in_map.setZero();
  integrated.gravity_in_map.setZero();
  integrated.gyro_bias = scans.back().gyro_bias_radps;
  Timestamp now = begin;
  for (const ScanEstimate& scan : scans) {
    for (const ImuStep& step : imu.steps(now, scan.time)) {
      integrated = propagated(integrated, step);
    }
    now = scan.time;
    integrated.map_from_imu = scan.map_from_imu.rotation.toRotationMatrix();
    const double t = to_seconds(now - begin);
    Eigen::Matrix<double, 3, 9> row;
    row << Eigen::Matrix3d::Identity(), t * Eigen::Matrix3d::Identity(),
        0.5 * t * t * Eigen::Matrix3d::Identity();
    normal += row.transpose() * row;
    right += row.transpose() * (scan.map_from_imu.translation - integrated.position_in_map);
  }
  // Gravity is known to be near 9.81 along the mean force: a weak prior carries short windows.
  constexpr double kPriorWeight = 1e-3;
  normal.diagonal().tail<3>().array() += kPriorWeight;
  right.tail<3>() += kPriorWeight * start.state.gravity_in_map;
  const Eigen::Matrix<double, 9, 1> solution = normal.ldlt().solve(right);
  const Eigen::Vector3d gravity = solution.tail<3>();
  if (!solution.allFinite() || gravity.norm() < 0.5 * kGravity_mps2) return std::nullopt;

  StateEstimate out = start;
  const Eigen::Matrix3d level_from_trial =
      level_rotation(-(start.state.map_from_imu.transpose() * gravity)) *
      start.state.map_from_imu.transpose();
  out.state.map_from_imu = level_from_trial * start.state.map_from_imu;
  out.state.velocity_in_map = level_from_trial * solution.segment<3>(3);
  out.state.gyro_bias = scans.back().gyro_bias_radps;
  set_variance(out, err::kVelocity, 3, 0.5);
  set_variance(out, err::kGyroBias, 3, 5e-3);
  set_variance(out, err::kGravity, 2, 0.03);
  return out;
}

}  // namespace hybridfusion
