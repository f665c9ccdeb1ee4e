#include "plane_adjustment.hpp"

#include "manifold.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

using Matrix63 = Eigen::Matrix<double, 6, 3>;

constexpr double kMinPlanePoints = 12.0;
// Cells whose second spread is below this share of the first hold an edge, not a face.
constexpr double kMinAspect = 0.02;
// Points of one segment on one plane share their errors: more than this many do not count more.
constexpr double kMaxClusterWeight = 20.0;
constexpr double kPointSigma_m = 0.03;
constexpr double kRobustScale_m = 0.05;

// A plane joins every two of its segments: more than these would only cost time and memory.
constexpr std::size_t kMaxMembers = 64;

/// At most kMaxMembers of a cell's clusters, spread over the drive, others in other cells.
std::vector<PlaneCluster> spread(std::span<const PlaneCluster> members) {
  const std::size_t stride = (members.size() + kMaxMembers - 1) / kMaxMembers;
  std::vector<PlaneCluster> out;
  out.reserve(std::min(members.size(), kMaxMembers) + 1);
  const std::size_t start = ((members.front().cell * 0x9E3779B97F4A7C15ULL) >> 32U) % stride;
  for (std::size_t i = start; i < members.size(); i += stride) out.push_back(members[i]);
  return out;
}

struct FittedPlane {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;  // columns by ascending spread: normal first
};

/// Plane of the points of several clusters together, or nothing when they do not form one.
std::optional<FittedPlane> fit(std::span<const PlaneCluster> members,
                               std::span<const Rigid3> map_from_segment,
                               std::span<const double> weights,
                               double max_sigma_m) {
  double total = 0.0;
  FittedPlane plane{.center = Eigen::Vector3d::Zero(), .axes = Eigen::Matrix3d::Identity()};
  for (std::size_t i = 0; i < members.size(); ++i) {
    total += weights[i];
    plane.center +=
        weights[i] * (map_from_segment[members[i].segment] * members[i].mean.cast<double>());
  }
  plane.center /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Rigid3& pose = map_from_segment[members[i].segment];
    const Eigen::Matrix3d r = pose.rotation.toRotationMatrix();
    const Eigen::Vector3d d = pose * members[i].mean.cast<double>() - plane.center;
    covariance +=
        weights[i] * (r * members[i].covariance.cast<double>() * r.transpose() + d * d.transpose());
  }
  covariance /= total;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  if (!(solver.eigenvalues()[0] <= max_sigma_m * max_sigma_m) ||
      !(solver.eigenvalues()[1] >= kMinAspect * solver.eigenvalues()[2]) ||
      !(solver.eigenvalues()[1] >= 4.0 * solver.eigenvalues()[0])) {
    return std::nullopt;
  }
  plane.axes = solver.eigenvectors();
  return plane;
}

/// Adds the sum over one plane's points, with the plane's own three parameters eliminated.
void add_plane(std::span<const PlaneCluster> members,
               std::span<const Rigid3> map_from_segment,
               std::span<const Eigen::Matrix3d> held,
               std::span<const double> weights,
               const FittedPlane& plane,
               PoseEquations& equations,
               std::vector<Matrix63>& couplings) {
  const Eigen::Vector3d normal = plane.axes.col(0);
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  couplings.resize(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const PlaneCluster& member = members[i];
    const Rigid3& pose = map_from_segment[member.segment];
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    const Eigen::Vector3d mean = member.mean.cast<double>();
    // Second moments of [q; 1] about the segment's origin.
    Eigen::Matrix4d moments;
    moments.topLeftCorner<3, 3>() = member.covariance.cast<double>() + mean * mean.transpose();
    moments.topRightCorner<3, 1>() = mean;
    moments.bottomLeftCorner<1, 3>() = mean.transpose();
    moments(3, 3) = 1.0;
    const double w = weights[i] / (kPointSigma_m * kPointSigma_m);
    const Eigen::Vector3d normal_in_segment = rotation.transpose() * normal;
    // r = n.(R q + t - c); its rows are linear in [q; 1]:
    // d r/d t = n, d r/d theta = q x R^T n, d r/d plane = [(p - c).u, (p - c).v, -1].
    Eigen::Matrix<double, 6, 4> pose_rows = Eigen::Matrix<double, 6, 4>::Zero();
    pose_rows.block<3, 1>(0, 3) = held.empty() ? normal : held[member.segment] * normal;
    pose_rows.block<3, 3>(3, 0) = -skew(normal_in_segment);
    Eigen::Matrix<double, 3, 4> plane_rows = Eigen::Matrix<double, 3, 4>::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector3d u = plane.axes.col(axis + 1);
      plane_rows.block<1, 3>(axis, 0) = (rotation.transpose() * u).transpose();
      plane_rows(axis, 3) = u.dot(pose.translation - plane.center);
    }
    plane_rows(2, 3) = -1.0;
    Eigen::Vector4d residual;
    residual << normal_in_segment, normal.dot(pose.translation - plane.center);
    equations.block(member.segment, member.segment) +=
        w * pose_rows * moments * pose_rows.transpose();
    equations.right(member.segment) -= w * pose_rows * moments * residual;
    couplings[i] = w * pose_rows * moments * plane_rows.transpose();
    c += w * plane_rows * moments * plane_rows.transpose();
  }
  // The plane is the best fit of these points, so its own gradient is zero and only H changes.
  const Eigen::Matrix3d inverse = c.inverse();
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Matrix63 scaled = couplings[i] * inverse;
    for (std::size_t j = i; j < members.size(); ++j) {
      equations.block(members[i].segment, members[j].segment).noalias() -=
          scaled * couplings[j].transpose();
    }
  }
}

}  // namespace

PlaneAdjustment::PlaneAdjustment(double max_plane_sigma_m,
                                 std::vector<Rigid3> map_from_segment,
                                 std::vector<Eigen::Matrix3d> held)
    : max_plane_sigma_m_(max_plane_sigma_m),
      map_from_segment_(std::move(map_from_segment)),
      held_(std::move(held)),
      equations_(map_from_segment_.size()) {}

void PlaneAdjustment::add(std::span<const PlaneCluster> clusters) {
  for (std::size_t first = 0; first < clusters.size();) {
    std::size_t last = first;
    double num_points = 0.0;
    while (last < clusters.size() && clusters[last].cell == clusters[first].cell) {
      num_points += clusters[last++].count;
    }
    if (last - first >= 2 && num_points >= kMinPlanePoints) {
      add_cell(spread(clusters.subspan(first, last - first)));
    }
    first = last;
  }
}

void PlaneAdjustment::add_cell(std::span<const PlaneCluster> members) {
  std::vector<double> weights;
  for (const PlaneCluster& member : members) {
    weights.push_back(std::min(static_cast<double>(member.count), kMaxClusterWeight));
  }
  auto plane = fit(members, map_from_segment_, weights, max_plane_sigma_m_);
  if (!plane) return;
  double sum_squares = 0.0;
  double sum_weights = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const double offset = plane->axes.col(0).dot(
        map_from_segment_[members[i].segment] * members[i].mean.cast<double>() - plane->center);
    const double scaled = offset / kRobustScale_m;
    weights[i] /= 1.0 + scaled * scaled;
    sum_squares += weights[i] * offset * offset;
    sum_weights += weights[i];
  }
  plane = fit(members, map_from_segment_, weights, max_plane_sigma_m_);
  if (!plane) return;
  std::vector<Matrix63> couplings;
  add_plane(members, map_from_segment_, held_, weights, *plane, equations_, couplings);
  sum_squares_ += sum_squares;
  sum_weights_ += sum_weights;
  ++report_.num_planes;
}

Expected<PlaneAdjustmentReport> PlaneAdjustment::solve(
    std::span<const RelativePose> links, std::span<const VelocityChange> velocity_changes) {
  if (map_from_segment_.size() < 2) return report_;
  for (const RelativePose& link : links) add_edge(link, 1.0, map_from_segment_, equations_);
  for (const VelocityChange& change : velocity_changes) {
    add_velocity_change(change, map_from_segment_, equations_);
  }
  HF_TRY(const Eigen::VectorXd step, equations_.solve());
  report_.max_shift_m = apply_step(step, map_from_segment_);
  report_.rms_before_m = sum_weights_ > 0.0 ? std::sqrt(sum_squares_ / sum_weights_) : 0.0;
  return report_;
}

}  // namespace hybridfusion
