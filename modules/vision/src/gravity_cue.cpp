#include "gravity_cue.hpp"

#include "robust_statistics.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kGimbalSigma_rad = 2.0 * kDegree;
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
  std::vector<Eigen::Vector3d> ups;
  for (std::size_t view = 0; view < photos.size(); ++view) {
    if (!model.world_from_view[view] || !photos[view].gimbal) continue;
    const double pitch = photos[view].gimbal->pitch_deg * kDegree;
    const double roll = photos[view].gimbal->roll_deg * kDegree;
    // Camera x right, y down, z forward; roll turns the camera clockwise about its axis.
    const Eigen::Vector3d up_in_camera(
        -std::sin(roll) * std::cos(pitch), -std::cos(roll) * std::cos(pitch), std::sin(pitch));
    ups.push_back(model.world_from_view[view]->rotation * up_in_camera);
  }
  // A few mounts among many photos say nothing about the rest's firmware.
  if (ups.size() < 3 || 2 * ups.size() < model.num_registered()) return std::nullopt;
  const Eigen::Vector3d up = robust_mean(ups);
  std::vector<double> gaps;
  for (const Eigen::Vector3d& u : ups) gaps.push_back((u - up).norm());
  constexpr double kMaxSpread_rad = 10.0 * kDegree;  // else the angles are not those of the photos
  if (median(gaps) > kMaxSpread_rad) return std::nullopt;
  return GravityCue{.up_in_world = up,
                    .sigma_rad = kGimbalSigma_rad,
                    .measured = true,
                    .source = "gimbal angles"};
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
