#include "cloud_sheet.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr std::size_t kNeighbors = 24;
constexpr double kMaxCurvature = 0.03;  // smallest eigenvalue over the sum: an edge of 20 degrees
// From errors against true surfaces: depths that photos share err less together than each alone,
// and a point errs a little more than its neighbours scatter, whose errors are alike.
constexpr double kOwnShare = 0.45;
constexpr double kScatterShare = 1.3;
// A point beside a sheet that holds this many times more depths a point, and farther from it than
// its points scatter, is an error of few photos.
constexpr double kFewDepths = 0.2;
constexpr double kMaxScatters = 3.0;

struct SheetPoint {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  float sigma_m = 0.0F;
  float distance_m = 0.0F;  ///< Sum over the neighbours.
  bool is_beside = false;   ///< Few depths beside a sheet of many.
};

/// Plane through the depths that the neighbours hold.
struct Sheet {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double scatter_m = 0.0;  ///< Of the depths about the plane.
  double curvature = 1.0;
  double num_depths = 0.0;  ///< A point, as most depths see it.
};

double num_depths_of(const PointCloud& cloud, std::size_t i) {
  return cloud.confidences.empty() ? 1.0 : static_cast<double>(cloud.confidences[i]);
}

/// Neighbours that hold few depths beside the others do not count.
Sheet sheet_of(const PointCloud& cloud, const std::vector<Neighbor>& neighbors) {
  Sheet sheet;
  double sum = 0.0;
  for (const Neighbor& n : neighbors) {
    const double w = num_depths_of(cloud, n.index);
    sum += w;
    sheet.num_depths += w * w;
  }
  if (!(sum > 0.0)) return sheet;
  sheet.num_depths /= sum;
  const auto weight_of = [&](const Neighbor& n) {
    const double w = num_depths_of(cloud, n.index);
    return w < kFewDepths * sheet.num_depths ? 0.0 : w;
  };
  sum = 0.0;
  for (const Neighbor& n : neighbors) {
    sum += weight_of(n);
    sheet.mean += weight_of(n) * cloud.points[n.index].cast<double>();
  }
  sheet.mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Neighbor& n : neighbors) {
    const Eigen::Vector3d d = cloud.points[n.index].cast<double>() - sheet.mean;
    covariance += weight_of(n) / sum * d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d values = solver.eigenvalues().cwiseMax(0.0);
  if (!(values.sum() > 0.0)) return sheet;
  sheet.normal = solver.eigenvectors().col(0);
  sheet.scatter_m = std::sqrt(values[0]);
  sheet.curvature = values[0] / values.sum();
  return sheet;
}

/// The point on its sheet; `normal` holds the direction to the photos and receives the normal.
SheetPoint on_sheet(const PointCloud& cloud,
                    std::size_t index,
                    const std::vector<Neighbor>& neighbors,
                    Eigen::Vector3f& normal) {
  SheetPoint result{.point = cloud.points[index], .sigma_m = cloud.sigmas_m[index]};
  for (const Neighbor& n : neighbors) result.distance_m += std::sqrt(n.squared_distance_m2);
  if (neighbors.size() < 3) return result;
  const Sheet sheet = sheet_of(cloud, neighbors);
  if (sheet.normal.isZero()) return result;
  const Eigen::Vector3d up =
      sheet.normal.dot(normal.cast<double>()) < 0.0 ? Eigen::Vector3d(-sheet.normal) : sheet.normal;
  normal = up.cast<float>();
  result.sigma_m =
      static_cast<float>(std::hypot(kOwnShare * result.sigma_m, kScatterShare * sheet.scatter_m));
  if (sheet.curvature > kMaxCurvature) return result;
  const Eigen::Vector3d at = cloud.points[index].cast<double>();
  result.is_beside = num_depths_of(cloud, index) < kFewDepths * sheet.num_depths &&
                     std::abs(up.dot(at - sheet.mean)) > kMaxScatters * sheet.scatter_m;
  double weights = 0.0;
  double height = 0.0;
  for (const Neighbor& n : neighbors) {
    const double sigma_m = cloud.sigmas_m[n.index];
    const double weight = num_depths_of(cloud, n.index) / (sigma_m * sigma_m);
    weights += weight;
    height += weight * up.dot(cloud.points[n.index].cast<double>() - at);
  }
  result.point = (at + height / weights * up).cast<float>();
  return result;
}

/// A flag for each point that is no speck.
std::vector<char> without_specks(const std::vector<SheetPoint>& points) {
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
  std::vector<char> is_kept(points.size());
  std::ranges::transform(points, is_kept.begin(), [&](const SheetPoint& p) {
    return static_cast<char>(!p.is_beside && p.distance_m <= mean + kMaxSigmas * deviation);
  });
  return is_kept;
}

/// Every point on its sheet; the normals of the cloud turn into those of the sheets.
std::vector<SheetPoint> sheet_points(PointCloud& cloud, const RunContext& ctx) {
  const KdTree tree(cloud.points);
  std::vector<SheetPoint> points(cloud.size());
  parallel_for(ctx, cloud.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i) {
      tree.nearest(cloud.points[i], kNeighbors + 1, neighbors);
      points[i] = on_sheet(cloud, i, neighbors, cloud.normals[i]);
    }
  });
  return points;
}

}  // namespace

PointCloud one_sheet(PointCloud cloud, const RunContext& ctx) {
  const std::vector<SheetPoint> points = sheet_points(cloud, ctx);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.points[i] = points[i].point;
    cloud.sigmas_m[i] = points[i].sigma_m;
  }
  if (cloud.size() > kNeighbors) keep_flagged(cloud, without_specks(points));
  return cloud;
}

}  // namespace hybridfusion
