#include "pose_equations.hpp"

#include "manifold.hpp"

#include <algorithm>
#include <array>

#include <Eigen/SparseCholesky>

namespace hybridfusion {

PoseEquations::PoseEquations(std::size_t num_poses)
    : diagonal_(num_poses, PoseMatrix::Zero()), right_(num_poses, PoseVector::Zero()) {}

PoseMatrix& PoseEquations::block(std::uint32_t row, std::uint32_t column) {
  if (row == column) return diagonal_[row];
  const std::uint64_t key = (static_cast<std::uint64_t>(row) << 32U) | column;
  const auto [at, added] = index_.try_emplace(key, blocks_.size());
  if (added) {
    keys_.push_back(key);
    blocks_.push_back(PoseMatrix::Zero());
  }
  return blocks_[at->second];
}

Eigen::SparseMatrix<double> PoseEquations::matrix() const {
  // Filled column by column: triplets would double the peak of the memory.
  struct Entry {
    std::uint32_t row = 0;
    const PoseMatrix* block = nullptr;
  };
  std::vector<std::vector<Entry>> columns(diagonal_.size());
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto row = static_cast<std::uint32_t>(keys_[b] >> 32U);
    if (row > 0) columns[keys_[b] & 0xFFFFFFFFU].push_back({.row = row, .block = &blocks_[b]});
  }
  const auto size = static_cast<Eigen::Index>(6 * (diagonal_.size() - 1));
  Eigen::SparseMatrix<double> h(size, size);
  h.reserve(static_cast<Eigen::Index>(36 * blocks_.size() + 21 * diagonal_.size()));
  for (std::uint32_t column = 1; column < diagonal_.size(); ++column) {
    std::vector<Entry>& entries = columns[column];
    std::ranges::sort(entries, {}, &Entry::row);
    for (int j = 0; j < 6; ++j) {
      const Eigen::Index at = 6 * (static_cast<Eigen::Index>(column) - 1) + j;
      h.startVec(at);
      for (const Entry& entry : entries) {
        for (int i = 0; i < 6; ++i) {
          h.insertBack(6 * (static_cast<Eigen::Index>(entry.row) - 1) + i, at) =
              (*entry.block)(i, j);
        }
      }
      for (int i = 0; i <= j; ++i) h.insertBack(at - j + i, at) = diagonal_[column](i, j);
    }
  }
  h.finalize();
  return h;
}

Expected<Eigen::VectorXd> PoseEquations::solve() const {
  const Eigen::SparseMatrix<double> h = matrix();
  Eigen::VectorXd g(h.cols());
  for (std::size_t i = 1; i < right_.size(); ++i) {
    g.segment<6>(static_cast<Eigen::Index>(6 * (i - 1))) = right_[i];
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> factor(h);
  if (factor.info() != Eigen::Success) {
    return fail(ErrorCode::kDegenerate, "the adjustment of the poses has no unique solution");
  }
  Eigen::VectorXd step = factor.solve(g);
  if (!step.allFinite()) {
    return fail(ErrorCode::kDegenerate, "the adjustment of the poses diverged");
  }
  return step;
}

PoseMatrix information_of(double sigma_m, double sigma_rad) {
  PoseVector diagonal;
  diagonal.head<3>().setConstant(1.0 / (sigma_m * sigma_m));
  diagonal.tail<3>().setConstant(1.0 / (sigma_rad * sigma_rad));
  return diagonal.asDiagonal();
}

PoseVector residual_of(const RelativePose& edge, const Rigid3& a, const Rigid3& b) {
  const Rigid3 first_from_second = a.inverse() * b;
  PoseVector residual;
  residual << first_from_second.translation - edge.first_from_second.translation,
      so3_log((edge.first_from_second.rotation.conjugate() * first_from_second.rotation)
                  .toRotationMatrix());
  return residual;
}

RelativePoseJacobians jacobians_of(const Rigid3& a, const Rigid3& b) {
  const Eigen::Matrix3d ra_t = a.rotation.toRotationMatrix().transpose();
  const Eigen::Matrix3d rb_t = b.rotation.toRotationMatrix().transpose();
  RelativePoseJacobians j;
  j.by_first.block<3, 3>(0, 0) = -ra_t;
  j.by_first.block<3, 3>(0, 3) = skew(ra_t * (b.translation - a.translation));
  j.by_first.block<3, 3>(3, 3) = -(rb_t * ra_t.transpose());
  j.by_second.block<3, 3>(0, 0) = ra_t;
  j.by_second.block<3, 3>(3, 3) = Eigen::Matrix3d::Identity();
  return j;
}

void add_edge(const RelativePose& edge,
              double weight,
              std::span<const Rigid3> map_from_body,
              PoseEquations& equations) {
  const Rigid3& a = map_from_body[edge.first];
  const Rigid3& b = map_from_body[edge.second];
  const PoseVector residual = residual_of(edge, a, b);
  const RelativePoseJacobians j = jacobians_of(a, b);
  const PoseMatrix information = weight * edge.information;
  const PoseMatrix first = j.by_first.transpose() * information;
  const PoseMatrix second = j.by_second.transpose() * information;
  equations.block(edge.first, edge.first) += first * j.by_first;
  equations.block(edge.second, edge.second) += second * j.by_second;
  equations.block(edge.first, edge.second) += first * j.by_second;
  equations.right(edge.first) -= first * residual;
  equations.right(edge.second) -= second * residual;
}

Eigen::Vector3d residual_of(const VelocityChange& change, std::span<const Rigid3> map_from_body) {
  const Eigen::Vector3d& before = map_from_body[change.middle - 1].translation;
  const Rigid3& middle = map_from_body[change.middle];
  const Eigen::Vector3d& behind = map_from_body[change.middle + 1].translation;
  return middle.rotation.conjugate() * ((behind - middle.translation) / change.behind_s -
                                        (middle.translation - before) / change.before_s) -
         change.in_middle_mps;
}

void add_velocity_change(const VelocityChange& change,
                         std::span<const Rigid3> map_from_body,
                         PoseEquations& equations) {
  const std::uint32_t k = change.middle;
  const Eigen::Vector3d residual = residual_of(change, map_from_body);
  const Eigen::Matrix3d rt = map_from_body[k].rotation.toRotationMatrix().transpose();
  using Rows = Eigen::Matrix<double, 3, 6>;
  std::array<Rows, 3> j{Rows::Zero(), Rows::Zero(), Rows::Zero()};
  j[0].leftCols<3>() = rt / change.before_s;
  j[1].leftCols<3>() = -rt * (1.0 / change.before_s + 1.0 / change.behind_s);
  j[1].rightCols<3>() = skew(residual + change.in_middle_mps);  // d(Exp(-theta) v) = [v]x theta
  j[2].leftCols<3>() = rt / change.behind_s;
  for (std::uint32_t a = 0; a < 3; ++a) {
    const Eigen::Matrix<double, 6, 3> weighted = j[a].transpose() * change.information;
    equations.right(k - 1 + a) -= weighted * residual;
    for (std::uint32_t b = a; b < 3; ++b) {
      equations.block(k - 1 + a, k - 1 + b) += weighted * j[b];
    }
  }
}

double apply_step(const Eigen::VectorXd& step, std::vector<Rigid3>& map_from_body) {
  double max_shift_m = 0.0;
  for (std::size_t i = 1; i < map_from_body.size(); ++i) {
    const PoseVector delta = step.segment<6>(static_cast<Eigen::Index>(6 * (i - 1)));
    Rigid3& pose = map_from_body[i];
    pose.translation += delta.head<3>();
    pose.rotation = (pose.rotation * Eigen::Quaterniond(so3_exp(delta.tail<3>()))).normalized();
    max_shift_m = std::max(max_shift_m, delta.head<3>().norm());
  }
  return max_shift_m;
}

}  // namespace hybridfusion
