#include "rig_fit.hpp"

#include "manifold.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kRotationSpan_s = 0.3;
constexpr double kWindow_s = 1.0;
constexpr double kWindowStep_s = 0.5;
constexpr double kGravity_mps2 = 9.80665;
constexpr std::size_t kMinRows = 20;
constexpr int kIterations = 12;
constexpr double kRobustSigmas = 3.0;

/// Poses i and j, and, for a velocity row, k.
struct Rows {
  std::vector<std::array<std::size_t, 2>> rotation = {};
  std::vector<std::array<std::size_t, 3>> velocity = {};
};

/// First pose at least `span_s` after pose i with only usable ones between; poses.size() for none.
std::size_t after(std::span<const LidarPose> poses, std::size_t i, double span_s) {
  for (std::size_t j = i; j < poses.size() && poses[j].usable; ++j) {
    const double passed_s = to_seconds(poses[j].time - poses[i].time);
    if (passed_s > 2.0 * span_s) break;
    if (passed_s >= span_s - 1e-3) return j;
  }
  return poses.size();
}

Rows choose_rows(std::span<const LidarPose> poses) {
  Rows rows;
  std::size_t next_rotation = 0;
  Timestamp next_window = poses.empty() ? Timestamp{} : poses.front().time;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i >= next_rotation) {
      const std::size_t j = after(poses, i, kRotationSpan_s);
      if (j < poses.size()) {
        rows.rotation.push_back({i, j});
        next_rotation = j;
      }
    }
    if (poses[i].time < next_window) continue;
    const std::size_t j = after(poses, i, kWindow_s);
    const std::size_t k = j < poses.size() ? after(poses, j, kWindow_s) : j;
    if (k >= poses.size()) continue;
    rows.velocity.push_back({i, j, k});
    next_window = poses[i].time + from_seconds(kWindowStep_s);
  }
  return rows;
}

/// IMU between neighbouring poses; changes with gyro bias and time offset only.
std::vector<ImuIncrement> integrate_between(std::span<const LidarPose> poses,
                                            const ImuBuffer& imu,
                                            const RigState& state) {
  const Timestamp offset = from_seconds(state.imu_time_offset_s);
  std::vector<ImuIncrement> out(poses.size());
  for (std::size_t i = 1; i < poses.size(); ++i) {
    for (const ImuStep& step : imu.steps(poses[i - 1].time - offset, poses[i].time - offset)) {
      integrate(step, state.gyro_bias, out[i]);
    }
  }
  return out;
}

struct Window {
  double duration_s = 0.0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// Specific force without bias from pose i to j, turned into the map by the LiDAR's own attitude.
Window window_between(std::span<const LidarPose> poses,
                      std::span<const ImuIncrement> increments,
                      const RigState& state,
                      std::size_t i,
                      std::size_t j) {
  Window sum;
  const Eigen::Quaterniond lidar_from_imu = state.imu_from_lidar.rotation.conjugate();
  for (std::size_t s = i + 1; s <= j; ++s) {
    const ImuIncrement& increment = increments[s];
    const Eigen::Quaterniond map_from_imu = poses[s - 1].map_from_lidar.rotation * lidar_from_imu;
    sum.position +=
        increment.duration_s * sum.velocity +
        map_from_imu * (increment.position_m + increment.position_by_accel_bias * state.accel_bias);
    sum.velocity += map_from_imu *
                    (increment.velocity_mps + increment.velocity_by_accel_bias * state.accel_bias);
    sum.duration_s += increment.duration_s;
  }
  return sum;
}

/// All rows, rotation first, three numbers each.
Eigen::VectorXd residuals(const Rows& rows,
                          std::span<const LidarPose> poses,
                          std::span<const ImuIncrement> increments,
                          const RigState& state) {
  Eigen::VectorXd out(3 * static_cast<Eigen::Index>(rows.rotation.size() + rows.velocity.size()));
  const Eigen::Matrix3d imu_from_lidar = state.imu_from_lidar.rotation.toRotationMatrix();
  Eigen::Index row = 0;
  for (const auto& [i, j] : rows.rotation) {
    Eigen::Matrix3d by_gyro = Eigen::Matrix3d::Identity();
    for (std::size_t s = i + 1; s <= j; ++s) by_gyro = by_gyro * increments[s].rotation;
    const Eigen::Matrix3d by_lidar =
        (poses[i].map_from_lidar.rotation.conjugate() * poses[j].map_from_lidar.rotation)
            .toRotationMatrix();
    // Hand-eye: X L X^T = G.
    out.segment<3>(row) =
        so3_log(imu_from_lidar * by_lidar.transpose() * imu_from_lidar.transpose() * by_gyro);
    row += 3;
  }
  const Eigen::Vector3d imu_in_lidar = state.imu_from_lidar.inverse().translation;
  const auto imu_in_map = [&](std::size_t s) -> Eigen::Vector3d {
    return poses[s].map_from_lidar * imu_in_lidar;
  };
  for (const auto& [i, j, k] : rows.velocity) {
    const Window a = window_between(poses, increments, state, i, j);
    const Window b = window_between(poses, increments, state, j, k);
    // As in fit_gravity: (pk - pj)/Tb - (pj - pi)/Ta = g (Ta + Tb)/2 + Va + Pb/Tb - Pa/Ta.
    out.segment<3>(row) = (imu_in_map(k) - imu_in_map(j)) / b.duration_s -
                          (imu_in_map(j) - imu_in_map(i)) / a.duration_s -
                          0.5 * (a.duration_s + b.duration_s) * state.gravity_in_map -
                          (a.velocity + b.position / b.duration_s - a.position / a.duration_s);
    row += 3;
  }
  return out;
}

/// Deviation of a group of rows by the median of their absolute values.
double robust_sigma(const Eigen::VectorXd& values, double smallest) {
  std::vector<double> sizes(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    sizes[static_cast<std::size_t>(i)] = std::abs(values[i]);
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return std::max(smallest, 1.4826 * *middle);
}

Eigen::MatrixXd jacobian(const Rows& rows,
                         std::span<const LidarPose> poses,
                         const ImuBuffer& imu,
                         std::span<const ImuIncrement> increments,
                         const RigState& state) {
  Eigen::MatrixXd out;
  for (int at = 0; at < rig::kSize; ++at) {
    // 0.2 ms of time, so that rounding to nanoseconds does not show; else small numbers of order 1.
    const double h = at == rig::kOffset ? 2e-4 : 1e-5;
    const RigState above = plus(state, h * RigVector::Unit(at));
    const RigState below = plus(state, -h * RigVector::Unit(at));
    const bool integrates = at >= rig::kOffset && at < rig::kAccelBias;
    const auto evaluate = [&](const RigState& x) {
      return integrates ? residuals(rows, poses, integrate_between(poses, imu, x), x)
                        : residuals(rows, poses, increments, x);
    };
    const Eigen::VectorXd column = (evaluate(above) - evaluate(below)) / (2.0 * h);
    if (at == 0) out.resize(column.size(), rig::kSize);
    out.col(at) = column;
  }
  return out;
}

/// Weak knowledge: pulls towards `given` and keeps what the drive does not show in place.
void add_prior(const RigState& given,
               const RigState& state,
               const std::array<bool, rig::kNumCalibrated>& held,
               RigMatrix& normal,
               RigVector& right) {
  constexpr double kHeld = 1e-7;
  RigVector sigma;
  sigma << 0.2, 0.2, 0.2, 0.5, 0.5, 0.5, 0.2, 0.1, 0.1, 0.1, 0.2, 0.2, 0.2, 20.0, 20.0, 20.0;
  for (int i = 0; i < rig::kNumCalibrated; ++i) {
    if (held[static_cast<std::size_t>(i)]) sigma[i] = kHeld;
  }
  RigVector off = RigVector::Zero();
  off.segment<3>(rig::kRotation) =
      so3_log((state.imu_from_lidar.rotation * given.imu_from_lidar.rotation.conjugate())
                  .toRotationMatrix());
  off.segment<3>(rig::kTranslation) =
      state.imu_from_lidar.translation - given.imu_from_lidar.translation;
  off[rig::kOffset] = state.imu_time_offset_s - given.imu_time_offset_s;
  off.segment<3>(rig::kGyroBias) = state.gyro_bias;
  off.segment<3>(rig::kAccelBias) = state.accel_bias;
  const RigVector weight = sigma.cwiseAbs2().cwiseInverse();
  normal.diagonal() += weight;
  right -= weight.cwiseProduct(off);
  constexpr double kGravitySigma = 0.02;
  const double norm = state.gravity_in_map.norm();
  const Eigen::Vector3d direction = state.gravity_in_map / norm;
  const double gravity_weight = 1.0 / (kGravitySigma * kGravitySigma);
  normal.block<3, 3>(rig::kGravity, rig::kGravity) +=
      gravity_weight * direction * direction.transpose();
  right.segment<3>(rig::kGravity) -= gravity_weight * (norm - kGravity_mps2) * direction;
}

}  // namespace

RigState plus(const RigState& state, const RigVector& d) {
  RigState out = state;
  out.imu_from_lidar.rotation =
      Eigen::Quaterniond(so3_exp(d.segment<3>(rig::kRotation))) * state.imu_from_lidar.rotation;
  out.imu_from_lidar.rotation.normalize();
  out.imu_from_lidar.translation += d.segment<3>(rig::kTranslation);
  out.imu_time_offset_s += d[rig::kOffset];
  out.gyro_bias += d.segment<3>(rig::kGyroBias);
  out.accel_bias += d.segment<3>(rig::kAccelBias);
  out.gravity_in_map += d.segment<3>(rig::kGravity);
  return out;
}

Expected<RigFit> fit_rig(std::span<const LidarPose> poses,
                         const ImuBuffer& imu,
                         const RigState& given,
                         const RigState& start,
                         const std::array<bool, rig::kNumCalibrated>& held) {
  const Rows rows = choose_rows(poses);
  if (rows.rotation.size() < kMinRows || rows.velocity.size() < kMinRows) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("calibration needs at least {} spans of 0.3 s and of 2 s that are "
                            "located without a gap, got {} and {}; record a longer drive",
                            kMinRows,
                            rows.rotation.size(),
                            rows.velocity.size()));
  }
  const auto split = 3 * static_cast<Eigen::Index>(rows.rotation.size());
  RigFit fit{.state = start};
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const auto increments = integrate_between(poses, imu, fit.state);
    const Eigen::VectorXd r = residuals(rows, poses, increments, fit.state);
    if (!r.allFinite()) break;
    const Eigen::Index rest = r.size() - split;
    const double rotation_sigma = robust_sigma(r.head(split), 1e-5);
    const double velocity_sigma = robust_sigma(r.tail(rest), 1e-4);
    const Eigen::MatrixXd j = jacobian(rows, poses, imu, increments, fit.state);
    Eigen::VectorXd weights(r.size());
    for (Eigen::Index i = 0; i < r.size(); ++i) {
      const double sigma = i < split ? rotation_sigma : velocity_sigma;
      // Windows overlap by three quarters: about every second one is independent.
      const double share = i < split ? 1.0 : 0.5;
      const double scaled = r[i] / (kRobustSigmas * sigma);
      weights[i] = share / (sigma * sigma * (1.0 + scaled * scaled));
    }
    RigMatrix normal = j.transpose() * weights.asDiagonal() * j;
    RigVector right = -j.transpose() * weights.cwiseProduct(r);
    add_prior(given, fit.state, held, normal, right);
    const Eigen::LDLT<RigMatrix> ldlt(normal);
    const RigVector step = ldlt.solve(right);
    if (!step.allFinite()) break;
    fit.state = plus(fit.state, step);
    fit.covariance = ldlt.solve(RigMatrix::Identity());
    fit.rms_rotation_rad = std::sqrt(r.head(split).squaredNorm() / static_cast<double>(split));
    fit.rms_velocity_mps = std::sqrt(r.tail(rest).squaredNorm() / static_cast<double>(rest));
    if (iteration > 2 && step.head<rig::kNumCalibrated>().cwiseAbs().maxCoeff() < 1e-6) break;
  }
  if (!fit.covariance.allFinite() || fit.covariance.isZero(0.0)) {
    return fail(ErrorCode::kDegenerate, "the calibration did not converge; is the rig far off?");
  }
  return fit;
}

}  // namespace hybridfusion
