#include "five_point.hpp"

#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

namespace hybridfusion {
namespace {

// Polynomials in x, y, z by degree; coefficients in these orders:
//   linear:    x y z 1
//   quadratic: x2 xy y2 xz yz z2 x y z 1
//   cubic:     x3 x2y xy2 y3 x2z xyz y2z xz2 yz2 z3, then the quadratic's ten
using Linear = Eigen::Matrix<double, 4, 1>;
using Quadratic = Eigen::Matrix<double, 10, 1>;
using Cubic = Eigen::Matrix<double, 20, 1>;

using Powers = std::array<int, 3>;
constexpr std::array<Powers, 20> kMonomials = {
    {{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {2, 0, 1}, {1, 1, 1}, {0, 2, 1},
     {1, 0, 2}, {0, 1, 2}, {0, 0, 3}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {1, 0, 1},
     {0, 1, 1}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
constexpr std::size_t kQuadratic = 10;  // first monomial of degree <= 2
constexpr std::size_t kLinear = 16;     // first monomial of degree <= 1

consteval std::size_t index_of(Powers wanted) {
  for (std::size_t k = 0; k < kMonomials.size(); ++k) {
    if (kMonomials[k] == wanted) return k;
  }
  return kMonomials.size();
}

/// Where the product of two monomials lies, both given relative to their own order.
template <std::size_t Rows, std::size_t Cols>
consteval std::array<std::array<std::size_t, Cols>, Rows> product_table(std::size_t first_row,
                                                                        std::size_t first_col) {
  std::array<std::array<std::size_t, Cols>, Rows> table{};
  for (std::size_t r = 0; r < Rows; ++r) {
    for (std::size_t c = 0; c < Cols; ++c) {
      const Powers& a = kMonomials[first_row + r];
      const Powers& b = kMonomials[first_col + c];
      for (std::size_t k = 0; k < kMonomials.size(); ++k) {
        if (kMonomials[k] == Powers{a[0] + b[0], a[1] + b[1], a[2] + b[2]}) table[r][c] = k;
      }
    }
  }
  return table;
}

Quadratic multiply(const Linear& a, const Linear& b) {
  static constexpr auto kTable = product_table<4, 4>(kLinear, kLinear);
  Quadratic result = Quadratic::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) result[kTable[i][j] - kQuadratic] += a[i] * b[j];
  }
  return result;
}

Cubic multiply(const Quadratic& a, const Linear& b) {
  static constexpr auto kTable = product_table<10, 4>(kQuadratic, kLinear);
  Cubic result = Cubic::Zero();
  for (std::size_t i = 0; i < 10; ++i) {
    for (std::size_t j = 0; j < 4; ++j) result[kTable[i][j]] += a[i] * b[j];
  }
  return result;
}

using LinearMatrix = std::array<std::array<Linear, 3>, 3>;

/// det E = 0 and 2 E E^T E - trace(E E^T) E = 0.
Eigen::Matrix<double, 10, 20> constraints(const LinearMatrix& e) {
  Eigen::Matrix<double, 10, 20> rows;
  const auto minor = [&](std::size_t a, std::size_t b) -> Quadratic {
    return multiply(e[1][a], e[2][b]) - multiply(e[1][b], e[2][a]);
  };
  rows.row(0) = multiply(minor(1, 2), e[0][0]) - multiply(minor(0, 2), e[0][1]) +
                multiply(minor(0, 1), e[0][2]);

  std::array<std::array<Quadratic, 3>, 3> eet;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      eet[i][j] =
          multiply(e[i][0], e[j][0]) + multiply(e[i][1], e[j][1]) + multiply(e[i][2], e[j][2]);
    }
  }
  const Quadratic half_trace = 0.5 * (eet[0][0] + eet[1][1] + eet[2][2]);
  for (std::size_t i = 0; i < 3; ++i) eet[i][i] -= half_trace;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rows.row(static_cast<Eigen::Index>(1 + 3 * i + j)) = multiply(eet[i][0], e[0][j]) +
                                                           multiply(eet[i][1], e[1][j]) +
                                                           multiply(eet[i][2], e[2][j]);
    }
  }
  return rows;
}

/// Multiplication by x on the basis {x2 xy y2 xz yz z2 x y z 1}, modulo the constraints.
Eigen::Matrix<double, 10, 10> action_matrix(const Eigen::Matrix<double, 10, 10>& reduced) {
  static constexpr std::array<std::size_t, 6> kCubicOf = {index_of({3, 0, 0}),
                                                          index_of({2, 1, 0}),
                                                          index_of({1, 2, 0}),
                                                          index_of({2, 0, 1}),
                                                          index_of({1, 1, 1}),
                                                          index_of({1, 0, 2})};
  Eigen::Matrix<double, 10, 10> action = Eigen::Matrix<double, 10, 10>::Zero();
  for (std::size_t k = 0; k < 6; ++k) {
    action.row(static_cast<Eigen::Index>(k)) = -reduced.row(static_cast<Eigen::Index>(kCubicOf[k]));
  }
  action(6, 0) = 1.0;  // x * x = x2
  action(7, 1) = 1.0;  // x * y = xy
  action(8, 3) = 1.0;  // x * z = xz
  action(9, 6) = 1.0;  // x * 1 = x
  return action;
}

}  // namespace

std::vector<Eigen::Matrix3d> essential_from_five_points(
    const std::array<Eigen::Vector2d, 5>& first, const std::array<Eigen::Vector2d, 5>& second) {
  Eigen::Matrix<double, 9, 5> epipolar;
  for (std::size_t i = 0; i < 5; ++i) {
    const Eigen::Vector3d a = first[i].homogeneous();
    const Eigen::Vector3d b = second[i].homogeneous();
    const auto column = static_cast<Eigen::Index>(i);
    epipolar.col(column) << b.x() * a, b.y() * a, b.z() * a;  // rows of E stacked
  }
  // The last four columns of Q span the null space of the five epipolar constraints.
  const Eigen::Matrix<double, 9, 9> q = epipolar.householderQr().householderQ();
  LinearMatrix e;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      e[i][j] = q.block<1, 4>(static_cast<Eigen::Index>(3 * i + j), 5).transpose();
    }
  }
  const Eigen::Matrix<double, 10, 20> rows = constraints(e);
  const Eigen::PartialPivLU<Eigen::Matrix<double, 10, 10>> lu(rows.leftCols<10>());
  const Eigen::Matrix<double, 10, 10> reduced = lu.solve(rows.rightCols<10>());
  if (!reduced.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::Matrix<double, 10, 10>> solver(action_matrix(reduced));
  if (solver.info() != Eigen::Success) return {};

  std::vector<Eigen::Matrix3d> solutions;
  for (Eigen::Index k = 0; k < 10; ++k) {
    if (std::abs(solver.eigenvalues()[k].imag()) > 1e-8) continue;
    const Eigen::Matrix<double, 10, 1> v = solver.eigenvectors().col(k).real();
    if (v[9] == 0.0) continue;
    const Eigen::Vector4d weights(v[6] / v[9], v[7] / v[9], v[8] / v[9], 1.0);
    Eigen::Matrix<double, 9, 1> stacked = q.rightCols<4>() * weights;
    stacked.normalize();
    if (!stacked.allFinite()) continue;
    solutions.push_back(
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(stacked.data()));
  }
  return solutions;
}

}  // namespace hybridfusion
