#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <ceres/crs_matrix.h>

namespace hybridfusion {

/// Normal equations of cameras behind scene points: the Schur complement of J^T J on the camera
/// columns, summed over rows that come in pieces. Photos that share no point have no entry.
class SchurComplement {
 public:
  /// @param block_sizes  Columns of each camera block; its entries are stored together.
  explicit SchurComplement(const std::vector<int>& block_sizes);

  /// Rows of a Jacobian whose first columns are those of points, three each, and the others those
  /// of all camera blocks. Every row may touch one point only; all rows of a point come at once.
  void add(const ceres::CRSMatrix& jacobian, int point_columns);

  [[nodiscard]] Eigen::SparseMatrix<double> lower_triangle() const;

 private:
  /// Rows of J^T J in the columns of one camera block.
  struct BlockColumns {
    int block = 0;
    Eigen::MatrixXd values = {};
  };
  struct Point {
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
    std::vector<BlockColumns> ties = {};  // of three rows, ascending
  };

  void add_row(const ceres::CRSMatrix& jacobian, int row, std::vector<Point>& points);
  void eliminate(const Point& point);
  /// @pre row_block >= column_block
  [[nodiscard]] Eigen::MatrixXd& entry(int row_block, int column_block);
  [[nodiscard]] int columns_of(int block) const;

  std::vector<int> first_column_ = {0};  // of each block, and one past the last
  std::vector<int> block_of_column_ = {};
  std::vector<std::map<int, Eigen::MatrixXd>> entries_ = {};  // by column block, row block
};

}  // namespace hybridfusion
