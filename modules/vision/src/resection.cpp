#include "resection.hpp"

#include "projection.hpp"
#include "rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr double kConfidence = 0.9999;
constexpr int kMinIterations = 30;
constexpr int kRefinements = 10;

struct Problem {
  const CameraIntrinsics& camera;
  IntrinsicsVector intrinsics;
  std::span<const Eigen::Vector2d> pixels;
  std::span<const Eigen::Vector3d> points;
  std::vector<Eigen::Vector2d> normalized;
};

/// Truncated squared errors in normalised coordinates; stops above `bound`.
double score(const Problem& problem, const Rigid3& pose, double limit2, double bound) {
  const Eigen::Matrix3d rotation = pose.rotation.conjugate().toRotationMatrix();
  const Eigen::Vector3d offset = -rotation * pose.translation;
  double sum = 0.0;
  for (std::size_t i = 0; i < problem.points.size() && sum <= bound; ++i) {
    const Eigen::Vector3d p = rotation * problem.points[i] + offset;
    const double error2 =
        p.z() > 0.0 ? (p.head<2>() / p.z() - problem.normalized[i]).squaredNorm() : limit2;
    sum += std::min(error2, limit2);
  }
  return sum;
}

std::vector<std::uint32_t> inliers_of(const Problem& problem, const Rigid3& pose, double limit_px) {
  std::vector<std::uint32_t> inliers;
  const Rigid3 camera_from_world = pose.inverse();
  for (std::uint32_t i = 0; i < problem.points.size(); ++i) {
    const Eigen::Vector3d p = camera_from_world * problem.points[i];
    if (p.z() <= 0.0) continue;
    if ((project(problem.camera, p) - problem.pixels[i]).norm() <= limit_px) inliers.push_back(i);
  }
  return inliers;
}

/// Gauss-Newton over [centre (world); rotation (right perturbation)] with Huber weights.
Rigid3 refine(const Problem& problem,
              Rigid3 pose,
              std::span<const std::uint32_t> members,
              double huber_px) {
  for (int iteration = 0; iteration < kRefinements; ++iteration) {
    const Eigen::Matrix3d camera_from_world = pose.rotation.conjugate().toRotationMatrix();
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (const std::uint32_t i : members) {
      const Eigen::Vector3d p = camera_from_world * (problem.points[i] - pose.translation);
      if (p.z() <= 0.0) continue;
      const Projection projection = project_with_jacobian(problem.intrinsics, p);
      const Eigen::Vector2d residual = projection.pixel - problem.pixels[i];
      Eigen::Matrix<double, 2, 6> jacobian;
      jacobian << -projection.by_point * camera_from_world, projection.by_point * skew(p);
      const double weight = std::min(1.0, huber_px / std::max(residual.norm(), 1e-12));
      normal += weight * jacobian.transpose() * jacobian;
      gradient += weight * jacobian.transpose() * residual;
    }
    const Eigen::Matrix<double, 6, 1> step = -normal.ldlt().solve(gradient);
    if (!step.allFinite()) break;
    pose.translation += step.head<3>();
    pose.rotation = (pose.rotation * rotation_exp(step.tail<3>())).normalized();
    if (step.tail<3>().norm() < 1e-9) break;
  }
  return pose;
}

int iterations_for(double inlier_share, int limit) {
  const double good = inlier_share * inlier_share * inlier_share;
  if (good >= 1.0 - 1e-12) return kMinIterations;
  if (good <= 1e-12) return limit;
  const double needed = std::ceil(std::log(1.0 - kConfidence) / std::log(1.0 - good));
  return std::clamp(static_cast<int>(std::min(needed, 1e9)), kMinIterations, limit);
}

std::array<std::uint32_t, 3> sample_three(std::uint32_t count, Random& random) {
  std::array<std::uint32_t, 3> sample{};
  do {
    for (auto& index : sample) index = random.index(count);
  } while (sample[0] == sample[1] || sample[0] == sample[2] || sample[1] == sample[2]);
  return sample;
}

}  // namespace

std::optional<Resection> resect_camera(const CameraIntrinsics& camera,
                                       std::span<const Eigen::Vector2d> pixels,
                                       std::span<const Eigen::Vector3d> points,
                                       const ResectionOptions& options,
                                       Random random) {
  const auto count = static_cast<std::uint32_t>(points.size());
  if (count < 4 || static_cast<int>(count) < options.min_inliers) return std::nullopt;
  Problem problem{camera, to_vector(camera), pixels, points, {}};
  for (const Eigen::Vector2d& pixel : pixels) {
    problem.normalized.push_back(unproject(camera, pixel));
  }
  const double coarse_px = 2.0 * options.max_error_px;
  const double limit2 = std::pow(coarse_px / camera.focal_px, 2.0);
  double best_score = std::numeric_limits<double>::infinity();
  Resection best;
  int limit = options.max_iterations;
  for (int iteration = 0; iteration < limit; ++iteration) {
    const std::array<std::uint32_t, 3> sample = sample_three(count, random);
    std::array<Eigen::Vector2d, 3> n;
    std::array<Eigen::Vector3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = problem.normalized[sample[k]];
      p[k] = points[sample[k]];
    }
    for (const Rigid3& pose : world_from_camera_by_three_points(n, p)) {
      const double sampled = score(problem, pose, limit2, best_score);
      if (sampled >= best_score) continue;
      best_score = sampled;
      best.inliers = inliers_of(problem, pose, coarse_px);
      best.world_from_camera = refine(problem, pose, best.inliers, options.max_error_px);
      best_score = std::min(best_score, score(problem, best.world_from_camera, limit2, best_score));
      limit = std::min(
          limit,
          iterations_for(static_cast<double>(best.inliers.size()) / count, options.max_iterations));
    }
  }
  if (best.inliers.size() < 4) return std::nullopt;
  best.inliers = inliers_of(problem, best.world_from_camera, coarse_px);
  best.world_from_camera =
      refine(problem, best.world_from_camera, best.inliers, 0.5 * options.max_error_px);
  best.inliers = inliers_of(problem, best.world_from_camera, options.max_error_px);
  if (static_cast<int>(best.inliers.size()) < options.min_inliers) return std::nullopt;
  return best;
}

}  // namespace hybridfusion
