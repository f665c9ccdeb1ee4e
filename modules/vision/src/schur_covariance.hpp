#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <ceres/ceres.h>

namespace hybridfusion {

/// Covariance of the parameters behind the points: the inverse of the Schur complement of J^T J on
/// them. Every row of `jacobian` may touch one point only.
/// @param point_columns  The first columns, three a point.
/// @returns Nothing when the parameters are not determined.
[[nodiscard]] std::optional<Eigen::MatrixXd> camera_covariance(const ceres::CRSMatrix& jacobian,
                                                               int point_columns);

/// Parameter blocks of a problem; those that it does not hold or holds constant do not count.
struct CovarianceBlocks {
  std::vector<double*> points = {};  ///< Three numbers each.
  std::vector<double*> poses = {};   ///< With a tangent of six.
  std::vector<double*> others = {};
};

/// Covariance of the tangent of every pose at the present values, losses applied; one per pose,
/// empty where nothing can be said.
[[nodiscard]] std::vector<std::optional<Eigen::Matrix<double, 6, 6>>> pose_covariances(
    ceres::Problem& problem, const CovarianceBlocks& blocks);

}  // namespace hybridfusion
