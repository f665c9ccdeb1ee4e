#include "scan_matching.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

constexpr int kNeighbors = 5;
// Neighbours whose second spread is below this share of the first lie along a line.
constexpr double kMinAspect = 0.12;
// Thicker than this share of their second spread they are leaves or an edge.
constexpr double kMaxThickness = 0.05;
// Scale of the Cauchy weight in standard deviations.
constexpr double kRobustSigmas = 3.0;

}  // namespace

std::optional<Plane> fit_plane(const MapNeighbors& neighbors, double max_offset_m) {
  Plane plane;
  for (int i = 0; i < neighbors.count; ++i) plane.center += neighbors.points[i].cast<double>();
  plane.center /= neighbors.count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int i = 0; i < neighbors.count; ++i) {
    const Eigen::Vector3d d = neighbors.points[i].cast<double>() - plane.center;
    covariance.noalias() += d * d.transpose();
  }
  covariance /= neighbors.count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d& spread = solver.eigenvalues();
  if (!(spread[1] > kMinAspect * spread[2]) || spread[0] > kMaxThickness * spread[1]) {
    return std::nullopt;
  }
  plane.normal = solver.eigenvectors().col(0);
  plane.sigma_m = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  for (int i = 0; i < neighbors.count; ++i) {
    const double offset = plane.normal.dot(neighbors.points[i].cast<double>() - plane.center);
    if (!(std::abs(offset) <= max_offset_m)) return std::nullopt;
  }
  return plane;
}

double point_to_plane(const NavState& state,
                      const Eigen::Vector3d& point_in_imu,
                      const Plane& plane,
                      MatchVector* row) {
  const Eigen::Vector3d point = state.map_from_imu * point_in_imu + state.position_in_map;
  if (row != nullptr) {
    const Eigen::Vector3d normal_in_imu = state.map_from_imu.transpose() * plane.normal;
    const Eigen::Vector3d point_in_lidar =
        state.imu_from_lidar.transpose() * (point_in_imu - state.lidar_in_imu);
    row->segment<3>(0) = plane.normal;
    row->segment<3>(3) = point_in_imu.cross(normal_in_imu);  // d(R q)/d(theta) = -R [q]x
    row->segment<3>(6) = normal_in_imu;
    row->segment<3>(9) = point_in_lidar.cross(state.imu_from_lidar.transpose() * normal_in_imu);
  }
  return plane.normal.dot(point - plane.center);
}

bool contains_ray(const Plane& plane, const Eigen::Vector3d& ray) {
  constexpr double kMinIncidenceSine = 0.08;
  return std::abs(plane.normal.dot(ray)) < kMinIncidenceSine * ray.norm();
}

Eigen::Vector3d trusted_normal(const Eigen::Vector3d& normal, const WeakDirections& weak) {
  constexpr double kStrongCosine = 0.5;
  Eigen::Vector3d trusted = normal;
  for (int i = 0; i < weak.count; ++i) {
    const double cosine = normal.dot(weak.directions[i]);
    if (std::abs(cosine) < kStrongCosine) trusted -= cosine * weak.directions[i];
  }
  return trusted;
}

ScanMatcher::ScanMatcher(const LocalMap& map, const LidarFilterOptions& options)
    : map_(map), options_(options) {}

void ScanMatcher::set_points(std::vector<Eigen::Vector3f> points_in_imu) {
  points_ = std::move(points_in_imu);
  planes_.assign(points_.size(), {.sigma_m = -1.0});
}

void ScanMatcher::update_points(const std::vector<Eigen::Vector3f>& points_in_imu) {
  points_ = points_in_imu;
}

void ScanMatcher::match(const NavState& state) {
  const Eigen::Matrix3f rotation = state.map_from_imu.cast<float>();
  const Eigen::Vector3f position = state.position_in_map.cast<float>();
  const auto radius = static_cast<float>(options_.neighbor_radius_m);
  float reach2 = 0.0F;
  map_.visit([&](const auto& map) {
    MapNeighbors neighbors;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      planes_[i].sigma_m = -1.0;
      map.nearest(rotation * points_[i] + position, kNeighbors, radius, neighbors);
      if (neighbors.count < kNeighbors) continue;
      const auto plane = fit_plane(neighbors, options_.max_plane_offset_m);
      if (!plane) continue;
      const Eigen::Vector3d ray =
          state.map_from_imu * (points_[i].cast<double>() - state.lidar_in_imu);
      if (contains_ray(*plane, ray)) continue;
      planes_[i] = *plane;
      reach2 = std::max(reach2, points_[i].squaredNorm());
    }
  });
  reach_m_ = std::sqrt(static_cast<double>(reach2));
}

MatchInformation ScanMatcher::linearize(const NavState& state, const WeakDirections& weak) const {
  MatchInformation sum;
  const double sigma2 = options_.point_sigma_m * options_.point_sigma_m;
  const bool with_extrinsic = options_.estimate_extrinsic;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Plane& plane = planes_[i];
    if (plane.sigma_m < 0.0) continue;
    const Eigen::Vector3d point = points_[i].cast<double>();
    MatchVector row;
    const double residual = point_to_plane(state, point, plane, &row);
    if (weak.count > 0) {
      Plane trusted = plane;
      trusted.normal = trusted_normal(plane.normal, weak);
      (void)point_to_plane(state, point, trusted, &row);
    }
    // The gate of FAST-LIO2: 1 - 0.9 |r| / sqrt(range) > 0.9.
    if (std::abs(residual) > std::sqrt(point.norm()) / 9.0) continue;
    const double variance = sigma2 + plane.sigma_m * plane.sigma_m / kNeighbors;
    const double scaled2 = residual * residual / (variance * kRobustSigmas * kRobustSigmas);
    const double weight = 1.0 / (variance * (1.0 + scaled2));
    ++sum.num_matched;
    sum.sum_abs_residual_m += std::abs(residual);
    sum.sum_weights += weight;
    if (with_extrinsic) {
      sum.information.noalias() += weight * row * row.transpose();
      sum.gradient -= weight * residual * row;
    } else {
      const Eigen::Matrix<double, kPoseSize, 1> h = row.head<kPoseSize>();
      sum.information.topLeftCorner<kPoseSize, kPoseSize>().noalias() += weight * h * h.transpose();
      sum.gradient.head<kPoseSize>() -= weight * residual * h;
    }
  }
  return sum;
}

}  // namespace hybridfusion
