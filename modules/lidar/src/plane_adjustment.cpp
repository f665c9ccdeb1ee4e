#include "plane_adjustment.hpp"

#include "manifold.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

namespace hybridfusion {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix63 = Eigen::Matrix<double, 6, 3>;

constexpr double kMinPlanePoints = 12.0;
// Cells whose second spread is below this share of the first hold an edge, not a face.
constexpr double kMinAspect = 0.02;
// Points of one segment on one plane share their errors: more than this many do not count more.
constexpr double kMaxClusterWeight = 20.0;
constexpr double kPointSigma_m = 0.03;
constexpr double kRobustScale_m = 0.05;

/// Block-sparse symmetric normal equations (upper triangle), six rows a segment.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t num_segments)
      : diagonal_(num_segments, Matrix6::Zero()), right_(num_segments, Vector6::Zero()) {}

  Matrix6& block(std::uint32_t row, std::uint32_t column) {
    if (row == column) return diagonal_[row];
    const std::uint64_t key = (static_cast<std::uint64_t>(row) << 32U) | column;
    const auto [at, added] = index_.try_emplace(key, blocks_.size());
    if (added) {
      keys_.push_back(key);
      blocks_.push_back(Matrix6::Zero());
    }
    return blocks_[at->second];
  }
  Vector6& right(std::uint32_t row) { return right_[row]; }

  /// Step with segment 0 held.
  [[nodiscard]] Expected<Eigen::VectorXd> solve() const {
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(36 * (blocks_.size() + diagonal_.size()));
    const auto add = [&](std::int64_t row, std::int64_t column, const Matrix6& m) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
          if (row != column || i <= j) triplets.emplace_back(6 * row + i, 6 * column + j, m(i, j));
        }
      }
    };
    for (std::size_t i = 1; i < diagonal_.size(); ++i) {
      add(static_cast<std::int64_t>(i) - 1, static_cast<std::int64_t>(i) - 1, diagonal_[i]);
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const auto row = static_cast<std::int64_t>(keys_[b] >> 32U);
      const auto column = static_cast<std::int64_t>(keys_[b] & 0xFFFFFFFFU);
      if (row > 0) add(row - 1, column - 1, blocks_[b]);
    }
    const auto size = static_cast<Eigen::Index>(6 * (diagonal_.size() - 1));
    Eigen::SparseMatrix<double> h(size, size);
    h.setFromTriplets(triplets.begin(), triplets.end());
    Eigen::VectorXd g(size);
    for (std::size_t i = 1; i < right_.size(); ++i) {
      g.segment<6>(static_cast<Eigen::Index>(6 * (i - 1))) = right_[i];
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> factor(h);
    if (factor.info() != Eigen::Success) {
      return fail(ErrorCode::kDegenerate, "the plane adjustment has no unique solution");
    }
    Eigen::VectorXd step = factor.solve(g);
    if (!step.allFinite()) {
      return fail(ErrorCode::kDegenerate, "the plane adjustment diverged");
    }
    return step;
  }

 private:
  std::vector<Matrix6> diagonal_;
  std::vector<Vector6> right_;
  std::vector<Matrix6> blocks_ = {};
  std::vector<std::uint64_t> keys_ = {};
  std::unordered_map<std::uint64_t, std::size_t> index_ = {};
};

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
               std::span<const double> weights,
               const FittedPlane& plane,
               NormalEquations& equations,
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
    pose_rows.block<3, 1>(0, 3) = normal;
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

void add_link(const SegmentLink& link,
              std::uint32_t first,
              std::span<const Rigid3> map_from_segment,
              NormalEquations& equations) {
  const Rigid3& a = map_from_segment[first];
  const Rigid3& b = map_from_segment[first + 1];
  const Eigen::Matrix3d ra = a.rotation.toRotationMatrix();
  const Eigen::Matrix3d rb = b.rotation.toRotationMatrix();
  const Eigen::Vector3d d = ra.transpose() * (b.translation - a.translation);
  const Eigen::Matrix3d measured = link.first_from_second.rotation.toRotationMatrix();
  // Residuals: [d - d_measured; Log(R_measured^T Ra^T Rb)]; t is perturbed in the map, R on the
  // right. Small residuals: the Jacobian of Log is taken as identity.
  Vector6 residual;
  residual << d - link.first_from_second.translation,
      so3_log(measured.transpose() * ra.transpose() * rb);
  Matrix6 ja = Matrix6::Zero();
  Matrix6 jb = Matrix6::Zero();
  ja.block<3, 3>(0, 0) = -ra.transpose();
  ja.block<3, 3>(0, 3) = skew(d);
  ja.block<3, 3>(3, 3) = -(rb.transpose() * ra);
  jb.block<3, 3>(0, 0) = ra.transpose();
  jb.block<3, 3>(3, 3) = Eigen::Matrix3d::Identity();
  Vector6 weight;
  weight.head<3>().setConstant(1.0 / (link.sigma_m * link.sigma_m));
  weight.tail<3>().setConstant(1.0 / (link.sigma_rad * link.sigma_rad));
  equations.block(first, first) += ja.transpose() * weight.asDiagonal() * ja;
  equations.block(first + 1, first + 1) += jb.transpose() * weight.asDiagonal() * jb;
  equations.block(first, first + 1) += ja.transpose() * weight.asDiagonal() * jb;
  equations.right(first) -= ja.transpose() * weight.asDiagonal() * residual;
  equations.right(first + 1) -= jb.transpose() * weight.asDiagonal() * residual;
}

}  // namespace

Expected<PlaneAdjustmentReport> adjust_planes(std::span<const PlaneCluster> clusters,
                                              std::span<const SegmentLink> links,
                                              double max_plane_sigma_m,
                                              std::vector<Rigid3>& map_from_segment) {
  HF_CHECK(links.size() + 1 == map_from_segment.size());
  PlaneAdjustmentReport report;
  if (map_from_segment.size() < 2) return report;
  NormalEquations equations(map_from_segment.size());
  std::vector<double> weights;
  std::vector<Matrix63> couplings;
  double sum_squares = 0.0;
  double sum_weights = 0.0;
  for (std::size_t first = 0; first < clusters.size();) {
    std::size_t last = first;
    double num_points = 0.0;
    while (last < clusters.size() && clusters[last].cell == clusters[first].cell) {
      num_points += clusters[last++].count;
    }
    const auto members = clusters.subspan(first, last - first);
    first = last;
    if (members.size() < 2 || num_points < kMinPlanePoints) continue;
    weights.clear();
    for (const PlaneCluster& member : members) {
      weights.push_back(std::min(static_cast<double>(member.count), kMaxClusterWeight));
    }
    auto plane = fit(members, map_from_segment, weights, max_plane_sigma_m);
    if (!plane) continue;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const double offset = plane->axes.col(0).dot(
          map_from_segment[members[i].segment] * members[i].mean.cast<double>() - plane->center);
      const double scaled = offset / kRobustScale_m;
      weights[i] /= 1.0 + scaled * scaled;
      sum_squares += weights[i] * offset * offset;
      sum_weights += weights[i];
    }
    plane = fit(members, map_from_segment, weights, max_plane_sigma_m);
    if (!plane) continue;
    add_plane(members, map_from_segment, weights, *plane, equations, couplings);
    ++report.num_planes;
  }
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    add_link(links[i], i, map_from_segment, equations);
  }
  HF_TRY(const Eigen::VectorXd step, equations.solve());
  for (std::size_t i = 1; i < map_from_segment.size(); ++i) {
    const Vector6 delta = step.segment<6>(static_cast<Eigen::Index>(6 * (i - 1)));
    Rigid3& pose = map_from_segment[i];
    pose.translation += delta.head<3>();
    pose.rotation = (pose.rotation * Eigen::Quaterniond(so3_exp(delta.tail<3>()))).normalized();
    report.max_shift_m = std::max(report.max_shift_m, delta.head<3>().norm());
  }
  report.rms_before_m = sum_weights > 0.0 ? std::sqrt(sum_squares / sum_weights) : 0.0;
  return report;
}

}  // namespace hybridfusion
