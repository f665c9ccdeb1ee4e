#include "schur_covariance.hpp"

#include "schur_complement.hpp"
#include "selected_inverse.hpp"

#include <cstddef>
#include <unordered_map>

#include <Eigen/SparseCore>

namespace hybridfusion {
namespace {

constexpr int kPose = 6;
constexpr std::size_t kBatchPoints = 16384;  // whose rows are in memory at a time

using Sparse = Eigen::SparseMatrix<double>;
using PoseCovariance = Eigen::Matrix<double, kPose, kPose>;

/// Points of one piece of the Jacobian and the residuals that touch them.
struct Batch {
  std::vector<double*> points = {};
  std::vector<ceres::ResidualBlockId> residuals = {};
};

/// All residuals of the problem, those of a point together; the last batch has those of no point.
std::vector<Batch> batches_of(const ceres::Problem& problem, const std::vector<double*>& points) {
  std::vector<Batch> batches(points.size() / kBatchPoints + 2);
  std::unordered_map<const double*, std::size_t> batch_of;
  for (std::size_t i = 0; i < points.size(); ++i) {
    batches[i / kBatchPoints].points.push_back(points[i]);
    batch_of[points[i]] = i / kBatchPoints;
  }
  std::vector<ceres::ResidualBlockId> residuals;
  problem.GetResidualBlocks(&residuals);
  std::vector<double*> touched;
  for (ceres::ResidualBlockId residual : residuals) {
    problem.GetParameterBlocksForResidualBlock(residual, &touched);
    std::size_t batch = batches.size() - 1;
    for (const double* block : touched) {
      if (const auto found = batch_of.find(block); found != batch_of.end()) batch = found->second;
    }
    batches[batch].residuals.push_back(residual);
  }
  return batches;
}

/// The covariance of all cameras where they share points; nothing when they are not determined.
Expected<std::optional<Sparse>> camera_covariance(ceres::Problem& problem,
                                                  const std::vector<double*>& points,
                                                  const std::vector<double*>& cameras,
                                                  const RunContext& ctx) {
  std::vector<int> sizes;
  sizes.reserve(cameras.size());
  for (const double* block : cameras) sizes.push_back(problem.ParameterBlockTangentSize(block));
  SchurComplement complement(sizes);
  const std::vector<Batch> batches = batches_of(problem, points);
  ProgressEvent progress{.stage = "vision/covariance",
                         .total = static_cast<std::int64_t>(batches.size()) + 1};
  for (const Batch& batch : batches) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    ctx.report(progress);
    ++progress.done;
    if (batch.residuals.empty()) continue;
    ceres::Problem::EvaluateOptions options;
    options.parameter_blocks = batch.points;
    options.parameter_blocks.insert(options.parameter_blocks.end(), cameras.begin(), cameras.end());
    options.residual_blocks = batch.residuals;
    ceres::CRSMatrix jacobian;
    if (!problem.Evaluate(options, nullptr, nullptr, nullptr, &jacobian)) {
      return std::nullopt;
    }
    complement.add(jacobian, 3 * static_cast<int>(batch.points.size()));
  }
  const Sparse matrix = complement.lower_triangle();
  // Columns differ by many powers of ten: rotations, metres, focal length.
  const Eigen::VectorXd scale =
      Eigen::VectorXd(matrix.diagonal()).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const auto scaled = [&](const Sparse& m) {
    return Sparse(scale.asDiagonal() * m * scale.asDiagonal());
  };
  ctx.report(progress);
  const auto inverse = selected_inverse(scaled(matrix));
  ++progress.done;
  ctx.report(progress);
  if (!inverse) return std::nullopt;
  return scaled(*inverse);
}

}  // namespace

Expected<std::vector<std::optional<PoseCovariance>>> pose_covariances(
    ceres::Problem& problem, const CovarianceBlocks& blocks, const RunContext& ctx) {
  std::vector<std::optional<PoseCovariance>> result(blocks.poses.size());
  const auto moves = [&](double* block) {
    return problem.HasParameterBlock(block) && !problem.IsParameterBlockConstant(block);
  };
  std::vector<double*> points;
  for (double* point : blocks.points) {
    if (moves(point)) points.push_back(point);
  }
  std::vector<double*> cameras;
  std::vector<std::size_t> poses;
  for (std::size_t k = 0; k < blocks.poses.size(); ++k) {
    if (!moves(blocks.poses[k])) continue;
    cameras.push_back(blocks.poses[k]);
    poses.push_back(k);
  }
  for (double* other : blocks.others) {
    if (moves(other)) cameras.push_back(other);
  }
  HF_TRY(const auto covariance, camera_covariance(problem, points, cameras, ctx));
  if (!covariance) return result;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k) * kPose;
    const PoseCovariance lower = covariance->block(at, at, kPose, kPose);
    result[poses[k]] = lower.selfadjointView<Eigen::Lower>();
  }
  return result;
}

}  // namespace hybridfusion
