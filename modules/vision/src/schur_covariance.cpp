#include "schur_covariance.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

constexpr int kPoint = 3;

/// Normal equations of one point: its own block and the blocks that tie it to camera columns.
struct PointBlock {
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  std::vector<std::pair<int, Eigen::Vector3d>> ties;  // by camera column

  Eigen::Vector3d& tie(int column) {
    const auto at =
        std::ranges::lower_bound(ties, column, {}, [](const auto& t) { return t.first; });
    if (at != ties.end() && at->first == column) return at->second;
    return ties.emplace(at, column, Eigen::Vector3d::Zero())->second;
  }
};

}  // namespace

std::optional<Eigen::MatrixXd> camera_covariance(const ceres::CRSMatrix& jacobian,
                                                 int point_columns) {
  const int size = jacobian.num_cols - point_columns;
  Eigen::MatrixXd reduced = Eigen::MatrixXd::Zero(size, size);
  std::vector<PointBlock> points(static_cast<std::size_t>(point_columns / kPoint));
  std::vector<std::pair<int, double>> cameras;
  for (int row = 0; row < jacobian.num_rows; ++row) {
    cameras.clear();
    PointBlock* block = nullptr;
    Eigen::Vector3d by_point = Eigen::Vector3d::Zero();
    for (int k = jacobian.rows[static_cast<std::size_t>(row)];
         k < jacobian.rows[static_cast<std::size_t>(row) + 1];
         ++k) {
      const int column = jacobian.cols[static_cast<std::size_t>(k)];
      const double value = jacobian.values[static_cast<std::size_t>(k)];
      if (column < point_columns) {
        block = &points[static_cast<std::size_t>(column / kPoint)];
        by_point[column % kPoint] = value;
      } else {
        cameras.emplace_back(column - point_columns, value);
      }
    }
    for (const auto& [a, value_a] : cameras) {
      for (const auto& [b, value_b] : cameras) reduced(a, b) += value_a * value_b;
    }
    if (block == nullptr) continue;
    block->own += by_point * by_point.transpose();
    for (const auto& [a, value] : cameras) block->tie(a) += value * by_point;
  }
  for (const PointBlock& block : points) {
    if (block.ties.empty()) continue;
    const Eigen::Matrix3d inverse = block.own.inverse();
    if (!inverse.allFinite()) continue;  // seen along one ray only: it tells nothing
    for (const auto& [a, tie_a] : block.ties) {
      const Eigen::Vector3d weighted = inverse * tie_a;
      for (const auto& [b, tie_b] : block.ties) reduced(a, b) -= weighted.dot(tie_b);
    }
  }
  // Columns differ by many powers of ten: rotations, metres, focal length.
  const Eigen::VectorXd scale = reduced.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * reduced * scale.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> solver(scaled);
  if (solver.info() != Eigen::Success || solver.rcond() < 1e-14) return std::nullopt;
  const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(size, size));
  return Eigen::MatrixXd(scale.asDiagonal() * inverse * scale.asDiagonal());
}

std::vector<std::optional<Eigen::Matrix<double, 6, 6>>> pose_covariances(
    ceres::Problem& problem, const CovarianceBlocks& blocks) {
  constexpr int kPose = 6;
  std::vector<std::optional<Eigen::Matrix<double, kPose, kPose>>> result(blocks.poses.size());
  ceres::Problem::EvaluateOptions options;
  const auto add = [&](double* block) {
    const bool moves = problem.HasParameterBlock(block) && !problem.IsParameterBlockConstant(block);
    if (moves) options.parameter_blocks.push_back(block);
    return moves;
  };
  for (double* point : blocks.points) add(point);
  const int point_columns = kPoint * static_cast<int>(options.parameter_blocks.size());
  std::vector<std::size_t> poses;
  for (std::size_t k = 0; k < blocks.poses.size(); ++k) {
    if (add(blocks.poses[k])) poses.push_back(k);
  }
  for (double* other : blocks.others) add(other);
  ceres::CRSMatrix jacobian;
  if (!problem.Evaluate(options, nullptr, nullptr, nullptr, &jacobian)) return result;
  const auto covariance = camera_covariance(jacobian, point_columns);
  if (!covariance) return result;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k) * kPose;
    result[poses[k]] = covariance->block<kPose, kPose>(at, at);
  }
  return result;
}

}  // namespace hybridfusion
