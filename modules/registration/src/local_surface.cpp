#include "local_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxNeighbors = 24;
/// A neighbourhood thinner than that (middle over largest variance) is a line, not a surface.
constexpr double kMinWidth = 0.05;

}  // namespace

double weight_of(const Neighbor& member, double radius_m) {
  return std::exp(-2.0 * static_cast<double>(member.squared_distance_m2) / (radius_m * radius_m));
}

std::optional<LocalPlane> local_plane(const Measured& measured,
                                      const std::vector<Neighbor>& members) {
  const PointCloud& cloud = measured.cloud;
  const InterpolationOptions& options = measured.options;
  double sum = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d about = cloud.points[members.front().index].cast<double>();
  for (const Neighbor& member : members) {
    const double weight = weight_of(member, options.radius_m);
    const Eigen::Vector3d d = cloud.points[member.index].cast<double>() - about;
    sum += weight;
    first += weight * d;
    second += weight * d * d.transpose();
  }
  first /= sum;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(second / sum - first * first.transpose());
  const Eigen::Vector3d& variance = solver.eigenvalues();
  if (!(variance[1] > kMinWidth * variance[2])) return std::nullopt;
  const double roughness_m = std::sqrt(std::max(0.0, variance[0]));
  if (roughness_m > options.max_roughness_m) return std::nullopt;
  return LocalPlane{.mean = about + first,
                    .normal = solver.eigenvectors().col(0),
                    .along = solver.eigenvectors().col(2),
                    .across = solver.eigenvectors().col(1),
                    .roughness_m = roughness_m};
}

bool find_neighbors(const Measured& measured,
                    const Eigen::Vector3f& at,
                    std::vector<Neighbor>& members) {
  const auto radius_m = static_cast<float>(measured.options.radius_m);
  measured.tree.nearest(at, kMaxNeighbors, radius_m, members);
  return members.size() >= static_cast<std::size_t>(measured.options.min_neighbors);
}

}  // namespace hybridfusion
