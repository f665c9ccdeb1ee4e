#include "schur_covariance.hpp"

#include "schur_complement.hpp"
#include "selected_inverse.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Eigen::MatrixXd random_matrix(int rows, int cols, Random& random) {
  Eigen::MatrixXd matrix(rows, cols);
  for (double& value : matrix.reshaped()) value = random.normal();
  return matrix;
}

ceres::CRSMatrix sparse(const Eigen::MatrixXd& dense) {
  ceres::CRSMatrix matrix;
  matrix.num_rows = static_cast<int>(dense.rows());
  matrix.num_cols = static_cast<int>(dense.cols());
  matrix.rows.push_back(0);
  for (int row = 0; row < dense.rows(); ++row) {
    for (int column = 0; column < dense.cols(); ++column) {
      if (dense(row, column) == 0.0) continue;
      matrix.cols.push_back(column);
      matrix.values.push_back(dense(row, column));
    }
    matrix.rows.push_back(static_cast<int>(matrix.cols.size()));
  }
  return matrix;
}

/// Rows of two points that three blocks of 2, 3 and 2 columns see, the first and the last not both.
Eigen::MatrixXd two_points(Random& random) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(16, 6 + 7);
  jacobian.block(0, 0, 8, 3) = random_matrix(8, 3, random);
  jacobian.block(0, 6, 8, 5) = random_matrix(8, 5, random);
  jacobian.block(8, 3, 8, 3) = random_matrix(8, 3, random);
  jacobian.block(8, 8, 8, 5) = random_matrix(8, 5, random);
  return jacobian;
}

TEST(SchurComplement, IsTheInverseOfTheCamerasBlockOfTheInverse) {
  Random random(3, "test/schur");
  const Eigen::MatrixXd jacobian = two_points(random);
  SchurComplement complement({2, 3, 2});
  complement.add(sparse(jacobian), 6);
  const Eigen::MatrixXd lower = complement.lower_triangle();
  const Eigen::MatrixXd whole = (jacobian.transpose() * jacobian).inverse();
  const Eigen::MatrixXd expected = whole.bottomRightCorner(7, 7).inverse();
  EXPECT_TRUE(lower.isApprox(Eigen::MatrixXd(expected.triangularView<Eigen::Lower>()), 1e-9));
  EXPECT_EQ(complement.lower_triangle().nonZeros(), 7 * 8 / 2 - 4) << "blocks that share no point";
}

TEST(SchurComplement, PiecesOfWholePointsAddUp) {
  Random random(4, "test/schur");
  const Eigen::MatrixXd jacobian = two_points(random);
  SchurComplement at_once({2, 3, 2});
  at_once.add(sparse(jacobian), 6);
  SchurComplement in_pieces({2, 3, 2});
  Eigen::MatrixXd piece(8, 10);
  piece << jacobian.block(0, 0, 8, 3), jacobian.block(0, 6, 8, 7);
  in_pieces.add(sparse(piece), 3);
  piece << jacobian.block(8, 3, 8, 3), jacobian.block(8, 6, 8, 7);
  in_pieces.add(sparse(piece), 3);
  EXPECT_TRUE(Eigen::MatrixXd(at_once.lower_triangle())
                  .isApprox(Eigen::MatrixXd(in_pieces.lower_triangle()), 1e-12));
}

TEST(SchurComplement, APointOnOneRayTellsNothing) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, 4);
  jacobian(0, 0) = jacobian(1, 1) = 1.0;  // the third direction of the point is free
  jacobian(0, 3) = 1.0;
  jacobian(2, 3) = 2.0;
  SchurComplement complement({1});
  complement.add(sparse(jacobian), 3);
  EXPECT_EQ(complement.lower_triangle().coeff(0, 0), 5.0);
}

/// A band beside columns that meet all others, as cameras along a flight beside their calibration.
Eigen::MatrixXd arrow(int size, Random& random) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3 * size, size);
  for (int row = 0; row < rows.rows(); ++row) {
    const int at = row % (size - 4);
    for (int k = 0; k < 3; ++k) rows(row, at + k) = random.normal();
    rows(row, size - 1) = 0.1 * random.normal();
  }
  const Eigen::MatrixXd matrix = rows.transpose() * rows + Eigen::MatrixXd::Identity(size, size);
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * matrix * scale.asDiagonal();
}

TEST(SelectedInverse, AgreesWithTheWholeInverse) {
  Random random(5, "test/selected-inverse");
  const Eigen::MatrixXd matrix = arrow(60, random);
  const Eigen::MatrixXd whole = matrix.inverse();
  const Eigen::SparseMatrix<double> lower =
      Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()).sparseView();
  ASSERT_LT(lower.nonZeros(), 300);
  const auto selected = selected_inverse(lower);
  ASSERT_TRUE(selected);
  ASSERT_EQ(selected->nonZeros(), lower.nonZeros());
  for (int column = 0; column < selected->outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(*selected, column); entry; ++entry) {
      EXPECT_NEAR(entry.value(), whole(entry.row(), entry.col()), 1e-12);
    }
  }
}

TEST(SelectedInverse, ASingularMatrixHasNone) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(4, 4);
  matrix(2, 1) = matrix(1, 2) = 1.0;
  EXPECT_FALSE(selected_inverse(matrix.sparseView()));
  matrix(2, 1) = matrix(1, 2) = 1.5;  // indefinite
  EXPECT_FALSE(selected_inverse(matrix.sparseView()));
}

/// r = A x_0 + B x_1 + ...
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(std::vector<Eigen::MatrixXd> factors) : factors_(std::move(factors)) {
    set_num_residuals(static_cast<int>(factors_.front().rows()));
    for (const Eigen::MatrixXd& factor : factors_) {
      mutable_parameter_block_sizes()->push_back(static_cast<int>(factor.cols()));
    }
  }
  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd> r(residuals, num_residuals());
    r.setZero();
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      r += factors_[i] * Eigen::Map<const Eigen::VectorXd>(parameters[i], factors_[i].cols());
      if (jacobians == nullptr || jacobians[i] == nullptr) continue;
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          jacobians[i], factors_[i].rows(), factors_[i].cols()) = factors_[i];
    }
    return true;
  }

 private:
  std::vector<Eigen::MatrixXd> factors_;
};

/// A row of poses; each point is seen from three that follow each other, and one calibration of two
/// numbers is theirs all.
struct Flight {
  std::vector<std::array<double, 6>> poses;
  std::vector<std::array<double, 3>> points;
  std::array<double, 2> calibration{};
  ceres::Problem problem;
  CovarianceBlocks blocks;

  Flight(std::size_t num_poses, bool has_positions)
      : poses(num_poses), points(4 * (num_poses - 2)) {
    Random random(8, "test/covariance");
    for (std::size_t p = 0; p < points.size(); ++p) {
      for (std::size_t v = p / 4; v < p / 4 + 3; ++v) {
        auto* cost = new LinearCost({random_matrix(2, 3, random),
                                     random_matrix(2, 6, random),
                                     random_matrix(2, 2, random)});
        problem.AddResidualBlock(
            cost, nullptr, {points[p].data(), poses[v].data(), calibration.data()});
      }
    }
    for (std::size_t v = 0; has_positions && v < num_poses; ++v) {
      auto* cost = new LinearCost({random_matrix(6, 6, random)});
      problem.AddResidualBlock(cost, nullptr, poses[v].data());
    }
    for (auto& point : points) blocks.points.push_back(point.data());
    for (auto& pose : poses) blocks.poses.push_back(pose.data());
    blocks.others.push_back(calibration.data());
  }

  /// The inverse of all normal equations, points first.
  [[nodiscard]] Eigen::MatrixXd whole_inverse() {
    ceres::Problem::EvaluateOptions options;
    for (const auto& group : {blocks.points, blocks.poses, blocks.others}) {
      options.parameter_blocks.insert(options.parameter_blocks.end(), group.begin(), group.end());
    }
    ceres::CRSMatrix rows;
    problem.Evaluate(options, nullptr, nullptr, nullptr, &rows);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows.num_rows, rows.num_cols);
    for (int row = 0; row < rows.num_rows; ++row) {
      for (int k = rows.rows[static_cast<std::size_t>(row)];
           k < rows.rows[static_cast<std::size_t>(row) + 1];
           ++k) {
        dense(row, rows.cols[static_cast<std::size_t>(k)]) =
            rows.values[static_cast<std::size_t>(k)];
      }
    }
    return (dense.transpose() * dense).inverse();
  }
};

TEST(PoseCovariances, AreBlocksOfTheWholeInverse) {
  Flight flight(12, true);
  const auto covariances = *pose_covariances(flight.problem, flight.blocks, {});
  const Eigen::MatrixXd whole = flight.whole_inverse();
  ASSERT_EQ(covariances.size(), 12U);
  for (std::size_t v = 0; v < covariances.size(); ++v) {
    ASSERT_TRUE(covariances[v]);
    const auto at = static_cast<Eigen::Index>(3 * flight.points.size() + 6 * v);
    EXPECT_TRUE(covariances[v]->isApprox(Matrix6(whole.block<6, 6>(at, at)), 1e-9)) << v;
  }
}

TEST(PoseCovariances, AHeldPoseHasNone) {
  Flight flight(12, true);
  flight.problem.SetParameterBlockConstant(flight.poses[3].data());
  const auto covariances = *pose_covariances(flight.problem, flight.blocks, {});
  EXPECT_FALSE(covariances[3]);
  EXPECT_TRUE(covariances[4]);
}

TEST(PoseCovariances, PosesThatNothingDeterminesHaveNone) {
  Flight flight(12, false);  // 240 rows for 194 unknowns: determined
  EXPECT_TRUE((*pose_covariances(flight.problem, flight.blocks, {}))[0]);
  std::array<double, 6> loose{};
  flight.problem.AddParameterBlock(loose.data(), 6);
  flight.blocks.poses.push_back(loose.data());
  EXPECT_FALSE((*pose_covariances(flight.problem, flight.blocks, {}))[0]);
}

TEST(PoseCovariances, AreThereForAThousandPoses) {
  Flight large(1000, true);
  const auto covariances = *pose_covariances(large.problem, large.blocks, {});
  EXPECT_TRUE(std::ranges::all_of(covariances, [](const auto& c) { return c.has_value(); }));
}

TEST(PoseCovariances, ReportTheirProgressToTheEnd) {
  Flight flight(12, true);
  std::vector<ProgressEvent> events;
  const RunContext ctx{.progress = [&](const ProgressEvent& event) { events.push_back(event); }};
  ASSERT_TRUE(pose_covariances(flight.problem, flight.blocks, ctx));
  ASSERT_GE(events.size(), 3U);
  EXPECT_EQ(events.front().done, 0);
  EXPECT_EQ(events.back().done, events.back().total);
  EXPECT_TRUE(std::ranges::is_sorted(events, {}, &ProgressEvent::done));
}

TEST(PoseCovariances, StopWhenAsked) {
  Flight flight(12, true);
  std::stop_source source;
  source.request_stop();
  const auto stopped =
      pose_covariances(flight.problem, flight.blocks, {.stop = source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace hybridfusion
