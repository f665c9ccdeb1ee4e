#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <ceres/ceres.h>

namespace hybridfusion {

/// Parameter blocks of a problem; those that it does not hold or holds constant do not count.
struct CovarianceBlocks {
  std::vector<double*> points = {};  ///< Three numbers each.
  std::vector<double*> poses = {};   ///< With a tangent of six.
  std::vector<double*> others = {};
};

/// Covariance of the tangent of every pose at the present values, losses applied; one per pose,
/// empty where nothing can be said: the blocks of the inverse of the Schur complement of J^T J.
/// Time and memory grow with the photos that share points, not with the square of all.
/// Reports as "vision/covariance". Fails with kCancelled.
[[nodiscard]] Expected<std::vector<std::optional<Eigen::Matrix<double, 6, 6>>>> pose_covariances(
    ceres::Problem& problem, const CovarianceBlocks& blocks, const RunContext& ctx);

}  // namespace hybridfusion
