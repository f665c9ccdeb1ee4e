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

namespace {

/// Accelerometer bias and gravity are each uncertain; their sum, the specific force that would be
/// measured at rest, is known: one update of the prior with it. b_a - R^T g = force.
void update_with_rest_force(const Eigen::Vector3d& force_mps2,
                            double sigma_mps2,
                            StateEstimate& out) {
  using ForceRows = Eigen::Matrix<double, 3, err::kSize>;
  const Eigen::Matrix3d imu_from_map = out.state.map_from_imu.transpose();
  ForceRows h = ForceRows::Zero();
  h.block<3, 3>(0, err::kAccelBias).setIdentity();
  h.block<3, 2>(0, err::kGravity) =
      -imu_from_map * s2_plus_jacobian(out.state.gravity_in_map, Eigen::Vector2d::Zero());
  const Eigen::Vector3d innovation =
      force_mps2 - out.state.accel_bias + imu_from_map * out.state.gravity_in_map;
  const Eigen::Matrix3d spread =
      h * out.covariance * h.transpose() + sigma_mps2 * sigma_mps2 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, err::kSize, 3> gain =
      out.covariance * h.transpose() * spread.inverse();
  const ErrorVector change = gain * innovation;
  const ErrorMatrix j = transport(out.state, change);
  const ErrorMatrix reduced = j * (out.covariance - gain * h * out.covariance) * j.transpose();
  out.state = plus(out.state, change);
  out.covariance = 0.5 * (reduced + reduced.transpose());
}

}  // namespace

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
  update_with_rest_force(mean.specific_force_mps2, force_sigma, out);
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

namespace {

/// Gyro bias for which the turns of the gyro are those of the scans; its deviation.
struct BiasFit {
  Eigen::Vector3d bias_radps = Eigen::Vector3d::Zero();
  double sigma_radps = 0.0;
};

BiasFit fit_gyro_bias(std::span<const ScanEstimate> scans, const ImuBuffer& imu) {
  // Over the whole window: the noise of two scan poses, and the correction is small enough for its
  // order not to matter.
  Eigen::Matrix3d by_gyro = Eigen::Matrix3d::Identity();
  for (const ImuStep& step : imu.steps(scans.front().time, scans.back().time)) {
    by_gyro = by_gyro * so3_exp(step.dt_s * step.angular_velocity_radps);
  }
  const Eigen::Matrix3d by_scans =
      (scans.front().map_from_imu.rotation.conjugate() * scans.back().map_from_imu.rotation)
          .toRotationMatrix();
  const double duration_s = to_seconds(scans.back().time - scans.front().time);
  // What a scan pose is off in motion, and what the gyro misses between samples.
  constexpr double kTurnSigma_rad = 2e-3;
  return {.bias_radps = so3_log(by_scans.transpose() * by_gyro) / duration_s,
          .sigma_radps = kTurnSigma_rad / duration_s + 1e-4};
}

/// p(t) = p0 + v0 t + 1/2 g t^2 + integral of the specific force turned into the map: [p0 v0 g].
struct PathFit {
  Eigen::Matrix<double, 9, 1> solution = Eigen::Matrix<double, 9, 1>::Zero();
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
};

PathFit fit_path(std::span<const ScanEstimate> scans,
                 Timestamp begin,
                 const ImuBuffer& imu,
                 const NavState& start,
                 double force_sigma_mps2) {
  Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Matrix<double, 9, 1> right = Eigen::Matrix<double, 9, 1>::Zero();
  double sum_squares = 0.0;
  NavState integrated = start;
  integrated.position_in_map.setZero();
  integrated.velocity_in_map.setZero();
  integrated.gravity_in_map.setZero();
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
    const Eigen::Vector3d moved = scan.map_from_imu.translation - integrated.position_in_map;
    normal += row.transpose() * row;
    right += row.transpose() * moved;
    sum_squares += moved.squaredNorm();
  }
  PathFit fit;
  fit.covariance = normal.inverse();
  fit.solution = fit.covariance * right;
  const double degrees = std::max(1.0, 3.0 * static_cast<double>(scans.size()) - 9.0);
  const double variance = std::max(0.0, sum_squares - right.dot(fit.solution)) / degrees;
  // Residuals of successive scans are alike, about three of them at a time.
  constexpr double kCorrelated = 3.0;
  fit.covariance *= kCorrelated * variance;
  fit.covariance.diagonal().tail<3>().array() += force_sigma_mps2 * force_sigma_mps2;
  return fit;
}

}  // namespace

std::optional<StateEstimate> fit_moving_state(std::span<const ScanEstimate> scans,
                                              Timestamp begin,
                                              const ImuBuffer& imu,
                                              const LidarRig& rig) {
  constexpr std::size_t kMinScans = 5;
  if (scans.size() < kMinScans) return std::nullopt;
  const BiasFit bias = fit_gyro_bias(scans, imu);
  NavState start;
  start.gyro_bias = bias.bias_radps;
  const double duration_s = to_seconds(scans.back().time - begin);
  // A turn rate that is off by its sigma tilts the force by this much at the end.
  const double force_sigma = 0.5 * kGravity_mps2 * bias.sigma_radps * duration_s +
                             2.0 * rig.imu_noise.accel_noise_density / std::sqrt(duration_s);
  const PathFit fit = fit_path(scans, begin, imu, start, force_sigma);
  const Eigen::Vector3d gravity = fit.solution.tail<3>();
  if (!fit.solution.allFinite() || gravity.norm() < 0.5 * kGravity_mps2) return std::nullopt;
  // The scan poses live in the frame of the IMU at `begin`: what is up there levels it.
  StateEstimate out = common_state(rig, -gravity);
  out.state.velocity_in_map = out.state.map_from_imu * fit.solution.segment<3>(3);
  out.state.gyro_bias = bias.bias_radps;
  const auto sigma_of = [&](int at) {
    return std::sqrt(fit.covariance.diagonal().segment<3>(at).mean());
  };
  // The first scan, which all others were matched to, was straightened by the velocity found.
  constexpr double kVelocityFloor_mps = 0.05;
  set_variance(out, err::kVelocity, 3, kVelocityFloor_mps + sigma_of(3));
  set_variance(out, err::kGyroBias, 3, bias.sigma_radps);
  set_variance(out, err::kAccelBias, 3, 0.1);
  set_variance(out, err::kGravity, 2, 0.1);
  update_with_rest_force(-gravity, 3e-3 + sigma_of(6), out);
  return out;
}

}  // namespace hybridfusion
