#include "gravity_cue.hpp"

#include "robust_statistics.hpp"
#include "rotation.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kGimbalSigma_rad = 2.0 * kDegree;
constexpr double kMountSigma_rad = 1.0 * kDegree;     // constant in the camera frame
constexpr double kReadingSigma_rad = 0.1 * kDegree;   // angles are written to a tenth of a degree
constexpr double kAttitudeSigma_rad = 0.2 * kDegree;  // common to all photos: what flight bends
constexpr double kLevelSigma_rad = 3.0 * kDegree;
constexpr double kCommonAxisSigma_rad = 5.0 * kDegree;

/// Mean direction, again over the directions within three deviations of it.
Eigen::Vector3d robust_mean(const std::vector<Eigen::Vector3d>& directions) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& d : directions) mean += d;
  mean.normalize();
  for (int round = 0; round < 3; ++round) {
    std::vector<double> gaps;
    for (const Eigen::Vector3d& d : directions) gaps.push_back((d - mean).norm());
    const double limit = std::max(3.0 * robust_sigma_about_zero(gaps), 1e-6);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < directions.size(); ++i) {
      if (gaps[i] <= limit) sum += directions[i];
    }
    if (sum.norm() > 0.0) mean = sum.normalized();
  }
  return mean;
}

/// Up direction and the constant error of the camera mount, a small turn b in the camera frame:
/// up = R_i (u_i + b x u_i). Photos of several headings tell both apart; with one heading, the
/// prior of b passes its uncertainty on to up.
GravityCue up_without_mount_error(const std::vector<Eigen::Matrix3d>& rotations,
                                  const std::vector<Eigen::Vector3d>& ups_in_camera,
                                  const Eigen::Vector3d& start) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Vector6 solution = Vector6::Zero();
  solution.head<3>() = start;
  Matrix6 normal;
  double sigma = kGimbalSigma_rad;
  for (int iteration = 0; iteration < 10; ++iteration) {
    normal.setZero();
    normal.bottomRightCorner<3, 3>().diagonal().setConstant(1.0 /
                                                            (kMountSigma_rad * kMountSigma_rad));
    // The length of up is 1: without this the six unknowns have a common null direction.
    normal.topLeftCorner<3, 3>() += start * start.transpose() / (1e-3 * 1e-3);
    Vector6 right = Vector6::Zero();
    right.head<3>() = start / (1e-3 * 1e-3);
    std::vector<double> gaps;
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      // up - R_i (b x u_i) = R_i u_i, and b x u = -[u]x b.
      Eigen::Matrix<double, 3, 6> jacobian;
      jacobian << Eigen::Matrix3d::Identity(), rotations[i] * skew(ups_in_camera[i]);
      const Eigen::Vector3d measured = rotations[i] * ups_in_camera[i];
      const Eigen::Vector3d residual = jacobian * solution - measured;
      gaps.insert(gaps.end(), {residual.x(), residual.y(), residual.z()});
      const double weight = 1.0 / (sigma * sigma + residual.squaredNorm());
      normal += weight * jacobian.transpose() * jacobian;
      right += weight * jacobian.transpose() * measured;
    }
    solution = normal.ldlt().solve(right);
    sigma = std::max(kReadingSigma_rad, robust_sigma_about_zero(std::move(gaps)));
  }
  const Matrix6 covariance = normal.inverse();
  const double formal = std::sqrt(covariance.topLeftCorner<2, 2>().diagonal().maxCoeff());
  return {.up_in_world = solution.head<3>().normalized(),
          .sigma_rad = std::hypot(kAttitudeSigma_rad, formal),
          .measured = true,
          .source = "gimbal angles"};
}

std::vector<Eigen::Vector3d> axes(const SfmModel& model, const Eigen::Vector3d& axis_in_camera) {
  std::vector<Eigen::Vector3d> result;
  for (const auto& pose : model.world_from_view) {
    if (pose) result.push_back(pose->rotation * axis_in_camera);
  }
  return result;
}

}  // namespace

std::optional<GravityCue> gravity_from_gimbals(const SfmModel& model,
                                               std::span<const PhotoMetadata> photos) {
  std::vector<Eigen::Matrix3d> rotations;
  std::vector<Eigen::Vector3d> ups_in_camera;
  std::vector<Eigen::Vector3d> ups;
  for (std::size_t view = 0; view < photos.size(); ++view) {
    if (!model.world_from_view[view] || !photos[view].gimbal) continue;
    const double pitch = photos[view].gimbal->pitch_deg * kDegree;
    const double roll = photos[view].gimbal->roll_deg * kDegree;
    // Camera x right, y down, z forward; roll turns the camera clockwise about its axis.
    ups_in_camera.emplace_back(
        -std::sin(roll) * std::cos(pitch), -std::cos(roll) * std::cos(pitch), std::sin(pitch));
    rotations.push_back(model.world_from_view[view]->rotation.toRotationMatrix());
    ups.push_back(rotations.back() * ups_in_camera.back());
  }
  // A few mounts among many photos say nothing about the rest's firmware.
  if (ups.size() < 3 || 2 * ups.size() < model.num_registered()) return std::nullopt;
  const Eigen::Vector3d up = robust_mean(ups);
  std::vector<double> gaps;
  for (const Eigen::Vector3d& u : ups) gaps.push_back((u - up).norm());
  constexpr double kMaxSpread_rad = 10.0 * kDegree;  // else the angles are not those of the photos
  if (median(gaps) > kMaxSpread_rad) return std::nullopt;
  return up_without_mount_error(rotations, ups_in_camera, up);
}

std::optional<GravityCue> gravity_from_level_rows(const SfmModel& model) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  const std::vector<Eigen::Vector3d> rows = axes(model, Eigen::Vector3d::UnitX());
  if (rows.size() < 3) return std::nullopt;
  for (const Eigen::Vector3d& row : rows) scatter += row * row.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter /
                                                              static_cast<double>(rows.size()));
  // Rows that span a plane: flat to 6 degrees, and with 12 degrees of spread within it.
  constexpr double kFlat = 0.01;
  constexpr double kSpread = 0.045;
  if (solver.eigenvalues()[0] > kFlat || solver.eigenvalues()[1] < kSpread) return std::nullopt;
  Eigen::Vector3d up = solver.eigenvectors().col(0);
  // Cameras do not stand on their heads and rarely look up.
  double votes = 0.0;
  for (const Eigen::Vector3d& axis : axes(model, Eigen::Vector3d::UnitZ())) votes -= up.dot(axis);
  for (const Eigen::Vector3d& down : axes(model, Eigen::Vector3d::UnitY())) votes -= up.dot(down);
  if (votes < 0.0) up = -up;
  return GravityCue{
      .up_in_world = up, .sigma_rad = kLevelSigma_rad, .measured = false, .source = "level rows"};
}

std::optional<GravityCue> gravity_from_common_axis(const SfmModel& model) {
  const std::vector<Eigen::Vector3d> all = axes(model, Eigen::Vector3d::UnitZ());
  if (all.size() < 3) return std::nullopt;
  const Eigen::Vector3d mean = robust_mean(all);
  std::vector<double> gaps;
  for (const Eigen::Vector3d& axis : all) gaps.push_back((axis - mean).norm());
  constexpr double kMaxSpread_rad = 10.0 * kDegree;
  if (median(gaps) > kMaxSpread_rad) return std::nullopt;
  return GravityCue{.up_in_world = -mean,
                    .sigma_rad = kCommonAxisSigma_rad,
                    .measured = false,
                    .source = "common viewing direction, taken as nadir"};
}

}  // namespace hybridfusion
