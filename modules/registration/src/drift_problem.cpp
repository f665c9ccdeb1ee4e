#include "drift_problem.hpp"

#include "fine_statistics.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Cholesky>

namespace hybridfusion {
namespace {

constexpr Eigen::Index kPerKnot = 4;  // shift and turn about z
constexpr double kGate_m = 0.5;       // what distances are cut at when they judge
constexpr double kPiecesPerInterval = 4.0;
// Priors of the change from knot to knot, in weights of one pair: 0.1 m and 0.2 deg a knot against
// pairs of 5 cm of which about 20 say the same.
constexpr double kShiftPrior = 5.0;
constexpr double kTurnPrior = 4000.0;
constexpr double kGaugePrior = 0.01;  // of these, towards no correction at all

}  // namespace

void DriftProblem::lay_knots(int intervals) {
  const auto [low, high] = std::ranges::minmax(at_);
  first_ = low;
  interval_ = (high - low) / intervals;
  correction_.knots.clear();
  for (int k = 0; k <= intervals; ++k) {
    DriftKnot knot{.at = low + k * interval_};
    double weight = 0.0;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const double w = std::max(0.0, 1.0 - std::abs(at_[i] - knot.at) / interval_);
      knot.pivot += w * inputs_.samples[i].point;
      weight += w;
    }
    if (weight > 0.0) knot.pivot /= weight;
    correction_.knots.push_back(knot);
  }
}

bool DriftProblem::is_held_out(std::size_t sample) const {
  const double piece = (at_[sample] - first_) / interval_ * kPiecesPerInterval;
  return static_cast<std::int64_t>(std::floor(piece)) % 4 == 2;
}

std::vector<DriftProblem::Pair> DriftProblem::find_pairs(double gate_m) {
  const std::vector<FineSample>& samples = inputs_.samples;
  std::vector<Neighbor> nearest(samples.size());
  std::vector<Eigen::Vector3d> moved(samples.size());
  parallel_for(ctx_, samples.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      moved[i] = pose_ * place(i);
      nearest[i] = inputs_.planes.tree().nearest(moved[i].cast<float>());
    }
  });
  // The nearest point of a thick or thin cloud may lie beside the foot: a wider gate for it.
  const auto limit = static_cast<float>((gate_m + 0.3) * (gate_m + 0.3));
  std::vector<std::size_t> wanted;
  for (const Neighbor& n : nearest) {
    if (n.squared_distance_m2 < limit) wanted.push_back(n.index);
  }
  inputs_.planes.prepare(std::move(wanted), ctx_);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!(nearest[i].squared_distance_m2 < limit)) continue;
    const LazyPlanes::Plane& plane = inputs_.planes.at(nearest[i].index);
    const Eigen::Vector3d normal = plane.normal.cast<double>();
    if (static_cast<double>(plane.curvature) > fine_.max_curvature ||
        std::abs(normal.dot(pose_.rotation * samples[i].normal)) < fine_.min_normal_cosine) {
      continue;
    }
    pairs.push_back({.sample = i,
                     .residual_m = normal.dot(moved[i] - plane.mean.cast<double>()),
                     .slope = pose_.scale * (pose_.rotation.inverse() * normal)});
  }
  return pairs;
}

void DriftProblem::add_pair(const Pair& pair, double weight, Equations& sum) const {
  const FineSample& sample = inputs_.samples[pair.sample];
  const auto last = static_cast<Eigen::Index>(correction_.knots.size()) - 2;
  const double place =
      std::clamp((at_[pair.sample] - first_) / interval_, 0.0, static_cast<double>(last + 1));
  const Eigen::Index k = std::min(static_cast<Eigen::Index>(place), last);
  const double share = place - static_cast<double>(k);
  Eigen::Matrix<double, 2 * kPerKnot, 1> jacobian;
  for (Eigen::Index side = 0; side < 2; ++side) {
    const DriftKnot& knot = correction_.knots[static_cast<std::size_t>(k + side)];
    const Eigen::Vector3d turned = Eigen::Vector3d::UnitZ().cross(sample.point - knot.pivot);
    jacobian.segment<kPerKnot>(kPerKnot * side) << pair.slope, pair.slope.dot(turned);
    jacobian.segment<kPerKnot>(kPerKnot * side) *= side == 0 ? 1.0 - share : share;
  }
  sum.normal.block<2 * kPerKnot, 2 * kPerKnot>(kPerKnot * k, kPerKnot * k) +=
      weight * jacobian * jacobian.transpose();
  sum.right.segment<2 * kPerKnot>(kPerKnot * k) -= weight * pair.residual_m * jacobian;
}

void DriftProblem::add_priors(Equations& sum) const {
  const auto value = [&](std::size_t k, Eigen::Index part) {
    const DriftKnot& knot = correction_.knots[k];
    return part < 3 ? knot.shift_m[part] : knot.turn_rad.z();
  };
  const std::size_t count = correction_.knots.size();
  for (std::size_t k = 0; k < count; ++k) {
    for (Eigen::Index part = 0; part < kPerKnot; ++part) {
      const double prior = part < 3 ? kShiftPrior : kTurnPrior;
      const Eigen::Index row = kPerKnot * static_cast<Eigen::Index>(k) + part;
      sum.normal(row, row) += kGaugePrior * prior;
      sum.right[row] -= kGaugePrior * prior * value(k, part);
      if (k + 1 == count) continue;
      const Eigen::Index next = row + kPerKnot;
      const double gap = value(k + 1, part) - value(k, part);
      sum.normal(row, row) += prior;
      sum.normal(next, next) += prior;
      sum.normal(row, next) -= prior;
      sum.normal(next, row) -= prior;
      sum.right[row] += prior * gap;
      sum.right[next] -= prior * gap;
    }
  }
}

void DriftProblem::solve(double gate_m, bool with_held_out) {
  std::vector<Pair> pairs = find_pairs(gate_m);
  std::erase_if(pairs, [&](const Pair& p) {
    return std::abs(p.residual_m) >= gate_m || (!with_held_out && is_held_out(p.sample));
  });
  std::array<std::vector<double>, 2> sizes;
  for (const Pair& p : pairs) {
    sizes[inputs_.samples[p.sample].is_vertical].push_back(std::abs(p.residual_m));
  }
  std::array<double, 2> widths{};
  for (std::size_t c = 0; c < 2; ++c) {
    widths[c] = std::clamp(6.0 * quantile(sizes[c], 0.5), 0.03, gate_m);
  }
  const auto size = kPerKnot * static_cast<Eigen::Index>(knots().size());
  Equations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (const Pair& p : pairs) {
    const double ratio = p.residual_m / widths[inputs_.samples[p.sample].is_vertical];
    if (std::abs(ratio) >= 1.0) continue;
    add_pair(p, (1.0 - ratio * ratio) * (1.0 - ratio * ratio), sum);  // Tukey
  }
  add_priors(sum);
  const Eigen::VectorXd update = sum.normal.ldlt().solve(sum.right);
  if (!update.allFinite()) return;
  for (std::size_t k = 0; k < knots().size(); ++k) {
    const auto row = kPerKnot * static_cast<Eigen::Index>(k);
    knots()[k].shift_m += update.segment<3>(row);
    knots()[k].turn_rad.z() += update[row + 3];
  }
}

double DriftProblem::judge() {
  std::array<double, 2> sums{};
  std::array<double, 2> counts{};
  for (const Pair& p : find_pairs(1.0)) {
    if (!is_held_out(p.sample)) continue;
    const auto c = static_cast<std::size_t>(inputs_.samples[p.sample].is_vertical);
    sums[c] += std::min(kGate_m, std::abs(p.residual_m));
    counts[c] += 1.0;
  }
  return 0.5 * (sums[0] / std::max(1.0, counts[0]) + sums[1] / std::max(1.0, counts[1]));
}

}  // namespace hybridfusion
