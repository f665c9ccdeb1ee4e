#include "schur_complement.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/LU>

namespace hybridfusion {
namespace {

constexpr int kPoint = 3;

}  // namespace

SchurComplement::SchurComplement(const std::vector<int>& block_sizes)
    : entries_(block_sizes.size()) {
  for (std::size_t block = 0; block < block_sizes.size(); ++block) {
    first_column_.push_back(first_column_.back() + block_sizes[block]);
    block_of_column_.resize(static_cast<std::size_t>(first_column_.back()),
                            static_cast<int>(block));
  }
}

int SchurComplement::columns_of(int block) const {
  const auto at = static_cast<std::size_t>(block);
  return first_column_[at + 1] - first_column_[at];
}

Eigen::MatrixXd& SchurComplement::entry(int row_block, int column_block) {
  Eigen::MatrixXd& matrix = entries_[static_cast<std::size_t>(column_block)][row_block];
  if (matrix.size() == 0) matrix.setZero(columns_of(row_block), columns_of(column_block));
  return matrix;
}

void SchurComplement::add_row(const ceres::CRSMatrix& jacobian,
                              int row,
                              std::vector<Point>& points) {
  const int point_columns = kPoint * static_cast<int>(points.size());
  Point* point = nullptr;
  Eigen::Vector3d by_point = Eigen::Vector3d::Zero();
  std::vector<BlockColumns> cameras;  // of one row
  const auto at_block = [&](std::vector<BlockColumns>& all, int block, int rows) -> auto& {
    const auto place = std::ranges::lower_bound(all, block, {}, &BlockColumns::block);
    if (place != all.end() && place->block == block) return place->values;
    return all.insert(place, {block, Eigen::MatrixXd::Zero(rows, columns_of(block))})->values;
  };
  const auto begin = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row)]);
  const auto end = static_cast<std::size_t>(jacobian.rows[static_cast<std::size_t>(row) + 1]);
  for (std::size_t k = begin; k < end; ++k) {
    const int column = jacobian.cols[k];
    if (column < point_columns) {
      point = &points[static_cast<std::size_t>(column / kPoint)];
      by_point[column % kPoint] = jacobian.values[k];
      continue;
    }
    const int camera_column = column - point_columns;
    const int block = block_of_column_[static_cast<std::size_t>(camera_column)];
    const int first = first_column_[static_cast<std::size_t>(block)];
    at_block(cameras, block, 1)(0, camera_column - first) = jacobian.values[k];
  }
  for (auto a = cameras.begin(); a != cameras.end(); ++a) {
    for (auto b = cameras.begin(); b <= a; ++b) {
      entry(a->block, b->block) += a->values.transpose() * b->values;
    }
  }
  if (point == nullptr) return;
  point->own += by_point * by_point.transpose();
  for (const auto& [block, values] : cameras) {
    at_block(point->ties, block, kPoint) += by_point * values;
  }
}

void SchurComplement::eliminate(const Point& point) {
  const Eigen::Matrix3d inverse = point.own.inverse();
  if (!inverse.allFinite()) return;  // seen along one ray only: it tells nothing
  for (auto a = point.ties.begin(); a != point.ties.end(); ++a) {
    const Eigen::MatrixXd weighted = a->values.transpose() * inverse;
    for (auto b = point.ties.begin(); b <= a; ++b) {
      entry(a->block, b->block) -= weighted * b->values;
    }
  }
}

void SchurComplement::add(const ceres::CRSMatrix& jacobian, int point_columns) {
  std::vector<Point> points(static_cast<std::size_t>(point_columns / kPoint));
  for (int row = 0; row < jacobian.num_rows; ++row) add_row(jacobian, row, points);
  for (const Point& point : points) eliminate(point);
}

Eigen::SparseMatrix<double> SchurComplement::lower_triangle() const {
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t column_block = 0; column_block < entries_.size(); ++column_block) {
    for (const auto& [row_block, matrix] : entries_[column_block]) {
      const int first_row = first_column_[static_cast<std::size_t>(row_block)];
      for (int c = 0; c < matrix.cols(); ++c) {
        const int column = first_column_[column_block] + c;
        for (int r = 0; r < matrix.rows(); ++r) {
          if (first_row + r >= column) triplets.emplace_back(first_row + r, column, matrix(r, c));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> lower(first_column_.back(), first_column_.back());
  lower.setFromTriplets(triplets.begin(), triplets.end());
  return lower;
}

}  // namespace hybridfusion
