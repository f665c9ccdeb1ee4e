#include "schur_covariance.hpp"

#include <hybridfusion/core/random.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Case {
  Eigen::MatrixXd dense;
  ceres::CRSMatrix sparse;
};

/// `points` points, each in `per_point` rows over all of `cameras` camera columns, and a prior row
/// for each camera column.
Case make_case(int points, int per_point, int cameras, double prior) {
  Random random(7, "test/schur");
  const int rows = points * per_point + cameras;
  Case c;
  c.dense = Eigen::MatrixXd::Zero(rows, 3 * points + cameras);
  for (int row = 0; row < points * per_point; ++row) {
    for (int k = 0; k < 3; ++k) c.dense(row, 3 * (row / per_point) + k) = random.normal();
    for (int k = 0; k < cameras; ++k) c.dense(row, 3 * points + k) = random.normal();
  }
  for (int k = 0; k < cameras; ++k) c.dense(points * per_point + k, 3 * points + k) = prior;
  c.sparse.num_rows = rows;
  c.sparse.num_cols = static_cast<int>(c.dense.cols());
  c.sparse.rows.push_back(0);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < c.sparse.num_cols; ++column) {
      if (c.dense(row, column) == 0.0) continue;
      c.sparse.cols.push_back(column);
      c.sparse.values.push_back(c.dense(row, column));
    }
    c.sparse.rows.push_back(static_cast<int>(c.sparse.cols.size()));
  }
  return c;
}

TEST(CameraCovariance, IsTheBlockOfTheWholeInverse) {
  const Case c = make_case(5, 6, 4, 0.5);
  const auto covariance = camera_covariance(c.sparse, 15);
  ASSERT_TRUE(covariance);
  const Eigen::MatrixXd whole = (c.dense.transpose() * c.dense).inverse();
  EXPECT_TRUE(covariance->isApprox(whole.bottomRightCorner(4, 4), 1e-9));
}

TEST(CameraCovariance, ParametersThatNothingDeterminesHaveNone) {
  Case c = make_case(2, 3, 4, 0.0);  // six rows for ten unknowns
  EXPECT_FALSE(camera_covariance(c.sparse, 6));
}

}  // namespace
}  // namespace hybridfusion
