#include "statistics.hpp"

#include <hybridfusion/evaluation/pose_error.hpp>

#include <cmath>
#include <vector>

namespace hybridfusion {
namespace {

std::vector<Eigen::Vector3d> centres(std::span<const Rigid3> poses) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(poses.size());
  for (const Rigid3& pose : poses) result.push_back(pose.translation);
  return result;
}

template <class Transform>
double rmse_after(const Transform& target_from_source,
                  const std::vector<Eigen::Vector3d>& target,
                  const std::vector<Eigen::Vector3d>& source) {
  double sum = 0.0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    sum += (target[i] - target_from_source * source[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(target.size()));
}

}  // namespace

Expected<CameraErrors> camera_errors(std::span<const Rigid3> truth_from_camera,
                                     std::span<const Rigid3> estimate_from_camera) {
  HF_CHECK(truth_from_camera.size() == estimate_from_camera.size());
  const std::vector<Eigen::Vector3d> truth = centres(truth_from_camera);
  const std::vector<Eigen::Vector3d> estimate = centres(estimate_from_camera);
  CameraErrors result{.num_cameras = truth.size()};
  HF_TRY(result.truth_from_estimate, fit_sim3(truth, estimate));
  HF_TRY(result.truth_from_estimate_rigid, fit_rigid3(truth, estimate));
  result.rigid_rmse_m = rmse_after(result.truth_from_estimate_rigid, truth, estimate);
  result.similarity_rmse_m = rmse_after(result.truth_from_estimate, truth, estimate);
  result.scale_error = 1.0 / result.truth_from_estimate.scale - 1.0;
  const Eigen::Quaterniond& alignment = result.truth_from_estimate.rotation;
  result.tilt_deg = tilt_deg(alignment);
  double horizontal = 0.0;
  double vertical = 0.0;
  std::vector<double> rotations_deg;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3d error = estimate[i] - truth[i];
    horizontal += error.head<2>().squaredNorm();
    vertical += error.z() * error.z();
    rotations_deg.push_back(to_deg(rotation_distance_rad(
        alignment * estimate_from_camera[i].rotation, truth_from_camera[i].rotation)));
  }
  const auto count = static_cast<double>(truth.size());
  result.absolute_horizontal_rmse_m = std::sqrt(horizontal / count);
  result.absolute_vertical_rmse_m = std::sqrt(vertical / count);
  result.absolute_rmse_m = std::sqrt((horizontal + vertical) / count);
  result.rotation_median_deg = quantile(rotations_deg, 0.5);
  result.rotation_max_deg = quantile(rotations_deg, 1.0);
  return result;
}

}  // namespace hybridfusion
