#include "levelling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr double kWindow_s = 1.5;
constexpr double kMaxWindow_s = 3.0;
constexpr double kPoseSigma_m = 0.01;
constexpr double kAccelBiasSigma_mps2 = 0.1;
constexpr std::size_t kMinWindows = 5;
constexpr double kMaxTiltSigma_rad = 5e-3;

/// Sum of IMU increments over scans (first, last], turned into the map by the scan poses.
struct Window {
  double duration_s = 0.0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d velocity_by_bias = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d position_by_bias = Eigen::Matrix3d::Zero();
};

std::optional<Window> window_between(std::span<const StoredScan> scans,
                                     std::size_t first,
                                     std::size_t last) {
  Window sum;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const ImuIncrement& increment = scans[i].since_last;
    if (increment.bridged) return std::nullopt;
    const Eigen::Matrix3d rotation = scans[i - 1].map_from_imu.rotation.toRotationMatrix();
    const double dt = increment.duration_s;
    sum.position += dt * sum.velocity + rotation * increment.position_m;
    sum.velocity += rotation * increment.velocity_mps;
    sum.position_by_bias += dt * sum.velocity_by_bias + rotation * increment.position_by_accel_bias;
    sum.velocity_by_bias += rotation * increment.velocity_by_accel_bias;
    sum.duration_s += dt;
  }
  return sum;
}

/// First scan at least kWindow_s after `from`; scans.size() when there is none.
std::size_t window_end(std::span<const StoredScan> scans, std::size_t from) {
  std::size_t end = from + 1;
  while (end < scans.size() && to_seconds(scans[end].time - scans[from].time) < kWindow_s) ++end;
  return end;
}

}  // namespace

std::optional<GravityFit> fit_gravity(std::span<const StoredScan> scans) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double squares = 0.0;
  std::size_t num_windows = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::size_t j = window_end(scans, i);
    if (j >= scans.size()) break;
    const std::size_t k = window_end(scans, j);
    if (k >= scans.size()) break;
    const auto a = window_between(scans, i, j);
    const auto b = window_between(scans, j, k);
    if (!a || !b || a->duration_s > kMaxWindow_s || b->duration_s > kMaxWindow_s) continue;
    // Mean velocities before and after scan j differ by what gravity, bias and force did:
    // (pk - pj)/Tb - (pj - pi)/Ta = g (Ta + Tb)/2 + Va + Pb/Tb - Pa/Ta + (bias terms).
    const auto at = [&](std::size_t s) -> const Eigen::Vector3d& {
      return scans[s].map_from_imu.translation;
    };
    const Eigen::Vector3d measured =
        (at(k) - at(j)) / b->duration_s - (at(j) - at(i)) / a->duration_s -
        (a->velocity + b->position / b->duration_s - a->position / a->duration_s);
    Eigen::Matrix<double, 3, 6> row;
    row << 0.5 * (a->duration_s + b->duration_s) * Eigen::Matrix3d::Identity(),
        a->velocity_by_bias + b->position_by_bias / b->duration_s -
            a->position_by_bias / a->duration_s;
    normal += row.transpose() * row;
    right += row.transpose() * measured;
    squares += measured.squaredNorm();
    ++num_windows;
  }
  if (num_windows < kMinWindows) return std::nullopt;
  // What the windows leave over says how good poses and IMU really are: slow samples, stamps that
  // lag and vibration show here.
  const Vector6 free = normal.ldlt().solve(right);
  const double degrees = std::max(1.0, 3.0 * static_cast<double>(num_windows) - 6.0);
  const double left_over = std::max(0.0, squares - right.dot(free)) / degrees;
  // Windows overlap: per second of data about one is independent.
  const double sigma = std::max(kPoseSigma_m * std::sqrt(6.0) / kWindow_s, std::sqrt(left_over));
  const double share =
      to_seconds(scans.back().time - scans.front().time) / static_cast<double>(num_windows);
  const double weight = std::min(1.0, share) / (sigma * sigma);
  normal *= weight;
  right *= weight;
  normal.diagonal().tail<3>().array() += 1.0 / (kAccelBiasSigma_mps2 * kAccelBiasSigma_mps2);
  const Matrix6 covariance = normal.inverse();
  const Vector6 solution = covariance * right;
  if (!solution.allFinite()) return std::nullopt;
  GravityFit fit{.gravity_in_map = solution.head<3>(), .accel_bias_mps2 = solution.tail<3>()};
  const double norm = fit.gravity_in_map.norm();
  if (norm < 8.0 || norm > 12.0) return std::nullopt;
  fit.tilt_sigma_rad = std::sqrt(covariance.topLeftCorner<2, 2>().trace()) / norm;
  return fit;
}

std::optional<InertialVelocityChange> inertial_velocity_change(std::span<const StoredScan> scans,
                                                               std::size_t first,
                                                               std::size_t middle,
                                                               std::size_t last,
                                                               const GravityFit& fit) {
  const auto a = window_between(scans, first, middle);
  const auto b = window_between(scans, middle, last);
  if (!a || !b || !(a->duration_s > 0.0) || !(b->duration_s > 0.0)) return std::nullopt;
  // The right side of the equation in fit_gravity.
  const Eigen::Vector3d by_bias = (a->velocity_by_bias + b->position_by_bias / b->duration_s -
                                   a->position_by_bias / a->duration_s) *
                                  fit.accel_bias_mps2;
  return InertialVelocityChange{
      .before_s = a->duration_s,
      .behind_s = b->duration_s,
      .in_map_mps = 0.5 * (a->duration_s + b->duration_s) * fit.gravity_in_map + a->velocity +
                    b->position / b->duration_s - a->position / a->duration_s + by_bias};
}

MapLevel level_map(std::vector<StoredScan>& scans) {
  if (scans.empty()) return {};
  Eigen::Vector3d down = Eigen::Vector3d::Zero();
  double sigma_rad = std::numeric_limits<double>::infinity();
  const auto fit = fit_gravity(scans);
  if (fit && fit->tilt_sigma_rad < kMaxTiltSigma_rad) {
    down = fit->gravity_in_map;
    sigma_rad = fit->tilt_sigma_rad;
  } else {
    // Late estimates know the accelerometer bias: they weigh by their own variance.
    for (const StoredScan& scan : scans) {
      if (scan.gravity_sigma_rad == 0.0) continue;
      const double sigma = std::max(scan.gravity_sigma_rad, 1e-6);
      down += (scan.map_from_imu.rotation * scan.gravity_in_imu).normalized() / (sigma * sigma);
      // One filter's estimates share their errors: their mean is no better than the best.
      sigma_rad = std::min(sigma_rad, sigma);
    }
    // Nor are they better than what the motion can tell from a bias at all: fast drives made the
    // filter believe in a tenth of a degree where it was off by one.
    if (fit && down.norm() > 0.0) sigma_rad = std::max(sigma_rad, fit->tilt_sigma_rad);
  }
  if (!down.allFinite() || down.norm() == 0.0) return {};
  return {.turn_rad = turn_upright(-down, scans), .sigma_rad = sigma_rad};
}

double turn_upright(const Eigen::Vector3d& up_in_map, std::vector<StoredScan>& scans) {
  const Eigen::Quaterniond level =
      Eigen::Quaterniond::FromTwoVectors(up_in_map, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d origin = scans.front().map_from_imu.translation;
  for (StoredScan& scan : scans) {
    scan.map_from_imu.translation = level * (scan.map_from_imu.translation - origin) + origin;
    scan.map_from_imu.rotation = (level * scan.map_from_imu.rotation).normalized();
  }
  return rotation_distance_rad(level, Eigen::Quaterniond::Identity());
}

}  // namespace hybridfusion
