#pragma once

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace hybridfusion {

template <int Dim>
using NdtVector = Eigen::Matrix<double, Dim, 1>;
template <int Dim>
inline constexpr int kNdtParams = Dim == 2 ? 3 : 6;

/// Normal distributions of the target, one per cell of a regular grid.
template <int Dim>
class NdtCells {
 public:
  struct Cell {
    NdtVector<Dim> mean = NdtVector<Dim>::Zero();
    Eigen::Matrix<double, Dim, Dim> information = Eigen::Matrix<double, Dim, Dim>::Zero();
  };

  NdtCells(std::span<const Eigen::Matrix<float, Dim, 1>> points, double cell_m, int min_points)
      : cell_m_(cell_m) {
    struct Sums {
      double count = 0.0;
      NdtVector<Dim> first = NdtVector<Dim>::Zero();
      Eigen::Matrix<double, Dim, Dim> second = Eigen::Matrix<double, Dim, Dim>::Zero();
    };
    std::vector<Sums> sums;
    std::vector<NdtVector<Dim>> corners;
    std::unordered_map<std::uint64_t, std::size_t> slot_of;
    for (const auto& point : points) {
      if (!point.allFinite()) continue;
      const NdtVector<Dim> p = point.template cast<double>();
      const Index index = index_of(p);
      const auto [entry, is_new] = slot_of.try_emplace(key_of(index), sums.size());
      if (is_new) {
        sums.emplace_back();
        corners.push_back(cell_m_ * index.template cast<double>());
      }
      Sums& s = sums[entry->second];
      // About the cell's corner: coordinates of kilometres would eat the digits of the covariance.
      const NdtVector<Dim> q = p - corners[entry->second];
      s.count += 1.0;
      s.first += q;
      s.second += q * q.transpose();
    }
    for (const auto& [key, slot] : slot_of) {
      const Sums& s = sums[slot];
      if (s.count < min_points) continue;
      const NdtVector<Dim> mean = s.first / s.count;
      const Eigen::Matrix<double, Dim, Dim> covariance =
          (s.second - s.count * mean * mean.transpose()) / (s.count - 1.0);
      Cell cell{.mean = corners[slot] + mean};
      if (invert_regularised(covariance, cell.information)) cells_.emplace(key, cell);
    }
  }

  [[nodiscard]] bool empty() const { return cells_.empty(); }

  /// Calls `visit(cell)` for the cell of `p` and its face neighbours.
  template <class Visit>
  void visit_near(const NdtVector<Dim>& p, Visit&& visit) const {
    const Index centre = index_of(p);
    visit_one(centre, visit);
    for (int axis = 0; axis < Dim; ++axis) {
      for (const int side : {-1, 1}) {
        Index beside = centre;
        beside[axis] += side;
        visit_one(beside, visit);
      }
    }
  }

 private:
  using Index = Eigen::Matrix<std::int64_t, Dim, 1>;

  [[nodiscard]] Index index_of(const NdtVector<Dim>& p) const {
    return (p / cell_m_).array().floor().template cast<std::int64_t>();
  }
  static std::uint64_t key_of(const Index& index) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      key = (key << 21U) | (static_cast<std::uint64_t>(index[axis] + (1 << 20)) & 0x1fffffU);
    }
    return key;
  }
  template <class Visit>
  void visit_one(const Index& index, Visit&& visit) const {
    const auto found = cells_.find(key_of(index));
    if (found != cells_.end()) visit(found->second);
  }
  /// Small eigenvalues are raised to 1 % of the largest (Magnusson 2009, 6.2.1); false for a cell
  /// whose points coincide.
  static bool invert_regularised(const Eigen::Matrix<double, Dim, Dim>& covariance,
                                 Eigen::Matrix<double, Dim, Dim>& information) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dim, Dim>> solver(covariance);
    const double largest = solver.eigenvalues()[Dim - 1];
    if (!(largest > 1e-10)) return false;
    const NdtVector<Dim> values = solver.eigenvalues().cwiseMax(0.01 * largest);
    information = solver.eigenvectors() * values.cwiseInverse().asDiagonal() *
                  solver.eigenvectors().transpose();
    return true;
  }

  double cell_m_;
  std::unordered_map<std::uint64_t, Cell> cells_;
};

/// Constants of the Gaussian that stands for the mixture with outliers (Magnusson 2009, Eq. 6.8):
/// objective -d1 exp(-d2/2 q' B q).
struct NdtMixture {
  double d1 = 1.0;
  double d2 = 1.0;
};
[[nodiscard]] inline NdtMixture make_mixture(double outlier_ratio, double cell_m, int dim) {
  const double c1 = 10.0 * (1.0 - outlier_ratio);
  const double c2 = outlier_ratio / std::pow(cell_m, dim);
  const double d3 = -std::log(c2);
  const double d1 = -(-std::log(c1 + c2) - d3);
  const double d2 = -2.0 * std::log((-std::log(c1 * std::exp(-0.5) + c2) - d3) / -d1);
  return {.d1 = d1, .d2 = d2};
}

/// Value, gradient and Hessian of the objective over [v; w] about `centre`, where a point moves to
/// centre + exp(w) (p - centre) + v, at v = w = 0.
template <int Dim>
struct NdtTerms {
  double value = 0.0;
  double density = 0.0;   ///< Sum over points of the largest exp(...).
  double distance = 0.0;  ///< Sum of the distances to the mean of that cell [m].
  double matched = 0.0;
  Eigen::Matrix<double, kNdtParams<Dim>, 1> gradient =
      Eigen::Matrix<double, kNdtParams<Dim>, 1>::Zero();
  Eigen::Matrix<double, kNdtParams<Dim>, kNdtParams<Dim>> hessian =
      Eigen::Matrix<double, kNdtParams<Dim>, kNdtParams<Dim>>::Zero();

  NdtTerms& operator+=(const NdtTerms& other) {
    value += other.value;
    density += other.density;
    distance += other.distance;
    matched += other.matched;
    gradient += other.gradient;
    hessian += other.hessian;
    return *this;
  }
};

template <int Dim>
[[nodiscard]] Eigen::Matrix<double, Dim, kNdtParams<Dim>> ndt_jacobian(const NdtVector<Dim>& arm) {
  Eigen::Matrix<double, Dim, kNdtParams<Dim>> jacobian;
  jacobian.template leftCols<Dim>().setIdentity();
  if constexpr (Dim == 2) {
    jacobian.col(2) << -arm.y(), arm.x();
  } else {
    for (int k = 0; k < 3; ++k) jacobian.col(3 + k) = Eigen::Vector3d::Unit(k).cross(arm);
  }
  return jacobian;
}

/// g' d2p / dw_i dw_j of the exponential map at w = 0.
template <int Dim>
void add_curvature(const NdtVector<Dim>& arm,
                   const NdtVector<Dim>& g,
                   double factor,
                   Eigen::Matrix<double, kNdtParams<Dim>, kNdtParams<Dim>>& hessian) {
  if constexpr (Dim == 2) {
    hessian(2, 2) -= factor * g.dot(arm);
  } else {
    // Symmetric part of e_i x (e_j x a) = e_j a_i - a delta_ij.
    const Eigen::Matrix3d outer = 0.5 * (arm * g.transpose() + g * arm.transpose());
    hessian.template bottomRightCorner<3, 3>() +=
        factor * (outer - arm.dot(g) * Eigen::Matrix3d::Identity());
  }
}

template <int Dim>
[[nodiscard]] NdtTerms<Dim> ndt_terms(const NdtCells<Dim>& cells,
                                      const NdtMixture& mixture,
                                      std::span<const NdtVector<Dim>> moved,
                                      const NdtVector<Dim>& centre,
                                      bool with_derivatives,
                                      const RunContext& ctx) {
  const auto add_chunk = [&](std::size_t begin, std::size_t end) {
    NdtTerms<Dim> terms;
    for (std::size_t i = begin; i < end; ++i) {
      const NdtVector<Dim> arm = moved[i] - centre;
      double best = 0.0;
      double distance = 0.0;
      bool is_matched = false;
      cells.visit_near(moved[i], [&](const typename NdtCells<Dim>::Cell& cell) {
        const NdtVector<Dim> q = moved[i] - cell.mean;
        const NdtVector<Dim> weighted = cell.information * q;
        const double density = std::exp(-0.5 * mixture.d2 * q.dot(weighted));
        is_matched = true;
        terms.value -= mixture.d1 * density;
        if (density >= best) {
          best = density;
          distance = q.norm();
        }
        if (!with_derivatives || density < 1e-8) return;
        const auto jacobian = ndt_jacobian<Dim>(arm);
        const double factor = mixture.d1 * mixture.d2 * density;
        const Eigen::Matrix<double, kNdtParams<Dim>, 1> slope = jacobian.transpose() * weighted;
        terms.gradient += factor * slope;
        terms.hessian += factor * (jacobian.transpose() * cell.information * jacobian -
                                   mixture.d2 * slope * slope.transpose());
        add_curvature<Dim>(arm, weighted, factor, terms.hessian);
      });
      if (!is_matched) continue;
      terms.matched += 1.0;
      terms.density += best;
      terms.distance += distance;
    }
    return terms;
  };
  return ordered_reduce(
      ctx, moved.size(), 2048, NdtTerms<Dim>{}, add_chunk, [](auto sum, const auto& part) {
        sum += part;
        return sum;
      });
}

}  // namespace hybridfusion
