#include "cloud_sheet.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/geometry/normals.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr std::size_t kNeighbors = 16;
constexpr double kMaxCurvature = 0.03;  // smallest eigenvalue over the sum: an edge of 20 degrees
// From errors against true surfaces: depths that photos share err less together than each alone,
// and a point errs a little more than its neighbours scatter, whose errors are alike.
constexpr double kOwnShare = 0.45;
constexpr double kScatterShare = 1.3;

struct SheetPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  float sigma_m = 0.0F;
  float distance_m = 0.0F;  ///< Sum over the neighbours.
};

/// The point on its sheet; `normal` holds the direction to the photos and receives the normal.
SheetPoint on_sheet(const PointCloud& cloud,
                    std::size_t index,
                    const std::vector<Neighbor>& neighbors,
                    Eigen::Vector3f& normal) {
  SheetPoint result{.point = cloud.points[index], .sigma_m = cloud.sigmas_m[index]};
  for (const Neighbor& n : neighbors) result.distance_m += std::sqrt(n.squared_distance_m2);
  if (neighbors.size() < 3) return result;
  Eigen::Vector3d mean;
  const Eigen::Matrix3d covariance = covariance_of(cloud.points, neighbors, mean);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  if (!(values.sum() > 0.0)) return result;
  Eigen::Vector3d up = solver.eigenvectors().col(0);
  if (up.dot(normal.cast<double>()) < 0.0) up = -up;
  normal = up.cast<float>();
  result.sigma_m = static_cast<float>(
      std::hypot(kOwnShare * result.sigma_m, kScatterShare * std::sqrt(values[0])));
  if (values[0] > kMaxCurvature * values.sum()) return result;
  const Eigen::Vector3d at = cloud.points[index].cast<double>();
  double weights = 0.0;
  double height = 0.0;
  for (const Neighbor& n : neighbors) {
    const double weight =
        1.0 / (static_cast<double>(cloud.sigmas_m[n.index]) * cloud.sigmas_m[n.index]);
    weights += weight;
    height += weight * up.dot(cloud.points[n.index].cast<double>() - at);
  }
  result.point = (at + height / weights * up).cast<float>();
  return result;
}

std::vector<std::size_t> without_specks(const std::vector<SheetPoint>& points) {
  constexpr double kMaxSigmas = 3.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const SheetPoint& p : points) {
    sum += p.distance_m;
    squares += static_cast<double>(p.distance_m) * p.distance_m;
  }
  const auto count = static_cast<double>(points.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].distance_m <= mean + kMaxSigmas * deviation) kept.push_back(i);
  }
  return kept;
}

}  // namespace

PointCloud one_sheet(PointCloud cloud, const RunContext& ctx) {
  const KdTree tree(cloud.points);
  std::vector<SheetPoint> points(cloud.size());
  parallel_for(ctx, cloud.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(cloud.points[i], kNeighbors + 1, neighbors);
      points[i] = on_sheet(cloud, i, neighbors, cloud.normals[i]);
    }
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.points[i] = points[i].point;
    cloud.sigmas_m[i] = points[i].sigma_m;
  }
  if (cloud.size() <= kNeighbors) return cloud;
  const std::vector<std::size_t> kept = without_specks(points);
  return kept.size() == cloud.size() ? cloud : select(cloud, kept);
}

}  // namespace hybridfusion
