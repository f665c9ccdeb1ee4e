#pragma once

#include <optional>

#include <Eigen/Core>
#include <ceres/ceres.h>

namespace hybridfusion {

/// Covariance of the parameters behind the points: the inverse of the Schur complement of J^T J on
/// them. Every row of `jacobian` may touch one point only.
/// @param point_columns  The first columns, three a point.
/// @returns Nothing when the parameters are not determined.
[[nodiscard]] std::optional<Eigen::MatrixXd> camera_covariance(const ceres::CRSMatrix& jacobian,
                                                               int point_columns);

}  // namespace hybridfusion
