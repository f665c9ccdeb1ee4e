#include "selected_inverse.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/SparseCholesky>

namespace hybridfusion {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// The inverse Z of L D L^T where L has entries, from the last column to the first:
/// Z_ij = -sum_k Z_ik L_kj, Z_jj = 1 / D_j - sum_k Z_jk L_kj, k over the entries of column j of L.
struct Inverse {
  Sparse below;  // strictly lower triangle; holds L in the columns that are still to come
  Eigen::VectorXd diagonal;

  Inverse(const Sparse& strictly_lower, const Eigen::VectorXd& pivots)
      : below(strictly_lower), diagonal(pivots.size()) {
    std::vector<int> place(static_cast<std::size_t>(pivots.size()), -1);  // in column j, by row
    for (int j = static_cast<int>(pivots.size()) - 1; j >= 0; --j) invert(j, pivots[j], place);
  }

  [[nodiscard]] double at(int row, int column) const {
    if (row == column) return diagonal[row];
    const int* rows = below.innerIndexPtr();
    const int* end = rows + below.outerIndexPtr()[column + 1];
    const int* found = std::lower_bound(rows + below.outerIndexPtr()[column], end, row);
    return found != end && *found == row ? below.valuePtr()[found - rows] : 0.0;
  }

 private:
  void invert(int j, double pivot, std::vector<int>& place) {
    const int* rows = below.innerIndexPtr() + below.outerIndexPtr()[j];
    double* values = below.valuePtr() + below.outerIndexPtr()[j];
    const int count = below.outerIndexPtr()[j + 1] - below.outerIndexPtr()[j];
    for (int i = 0; i < count; ++i) place[static_cast<std::size_t>(rows[i])] = i;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(count);
    for (int i = 0; i < count; ++i) {
      sums[i] += diagonal[rows[i]] * values[i];
      for (Sparse::InnerIterator z(below, rows[i]); z; ++z) {
        const int k = place[static_cast<std::size_t>(z.row())];
        if (k < 0) continue;
        sums[k] += z.value() * values[i];
        sums[i] += z.value() * values[k];
      }
    }
    diagonal[j] = 1.0 / pivot;
    for (int i = 0; i < count; ++i) {
      diagonal[j] += sums[i] * values[i];
      values[i] = -sums[i];
      place[static_cast<std::size_t>(rows[i])] = -1;
    }
  }
};

}  // namespace

std::optional<Sparse> selected_inverse(const Sparse& lower) {
  constexpr double kMinPivot = 1e-13;  // of a diagonal of ones: what rounding leaves of nothing
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factor(lower);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd pivots = factor.vectorD();
  if (!std::ranges::all_of(pivots, [](double pivot) { return pivot > kMinPivot; })) {
    return std::nullopt;
  }
  const Inverse inverse(factor.matrixL().nestedExpression(), pivots);
  const auto& place = factor.permutationP().indices();
  Sparse result = lower;
  for (int column = 0; column < result.outerSize(); ++column) {
    for (Sparse::InnerIterator entry(result, column); entry; ++entry) {
      const auto [first, last] = std::minmax(place[entry.row()], place[column]);
      entry.valueRef() = inverse.at(last, first);
    }
  }
  return result;
}

}  // namespace hybridfusion
