#include "fine_problem.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace hybridfusion {
namespace {

double tukey(double residual, double width) {
  const double ratio = residual / width;
  return std::abs(ratio) < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
}

}  // namespace

std::vector<FinePair> FineProblem::find_pairs(double gate_m, std::size_t stride) {
  const std::size_t count = (samples_.size() + stride - 1) / stride;
  std::vector<Neighbor> nearest(count);
  std::vector<Eigen::Vector3d> moved(count);
  parallel_for(ctx_, count, 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      moved[k] = pose_ * samples_[k * stride].point;
      nearest[k] = planes_.tree().nearest(moved[k].cast<float>());
    }
  });
  const auto limit = static_cast<float>(gate_m * gate_m);
  std::vector<std::size_t> wanted;
  centre_.setZero();
  held_out_near_ = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (samples_[k * stride].is_held_out && nearest[k].squared_distance_m2 < 2.25F) {
      held_out_near_ += 1.0;
    }
    if (!(nearest[k].squared_distance_m2 < limit)) continue;
    wanted.push_back(nearest[k].index);
    centre_ += moved[k];
  }
  if (wanted.empty()) return {};
  centre_ /= static_cast<double>(wanted.size());
  planes_.prepare(std::move(wanted), ctx_);
  std::vector<FinePair> pairs;
  for (std::size_t k = 0; k < count; ++k) {
    if (!(nearest[k].squared_distance_m2 < limit)) continue;
    const LazyPlanes::Plane& plane = planes_.at(nearest[k].index);
    const FineSample& sample = samples_[k * stride];
    const Eigen::Vector3d normal = plane.normal.cast<double>();
    const double cosine = std::abs(normal.dot(pose_.rotation * sample.normal));
    if (static_cast<double>(plane.curvature) > options_.max_curvature ||
        cosine < options_.min_normal_cosine) {
      continue;
    }
    FinePair pair{.point = sample.point,
                  .is_vertical = sample.is_vertical,
                  .is_held_out = sample.is_held_out};
    pair.residual_m =
        plane_residual(moved[k], plane.mean.cast<double>(), normal, centre_, pair.jacobian);
    if (std::abs(pair.residual_m) < gate_m) pairs.push_back(pair);
  }
  return pairs;
}

double FineProblem::step(std::vector<FinePair>& pairs, double gate_m, bool free_scale) {
  std::array<std::vector<double>, 2> sizes;
  for (const FinePair& pair : pairs) sizes[pair.is_vertical].push_back(std::abs(pair.residual_m));
  std::array<double, 2> widths{};
  for (std::size_t c = 0; c < 2; ++c) {
    widths[c] = std::clamp(6.0 * quantile(sizes[c], 0.5), 0.03, gate_m);
  }
  std::array<double, 2> totals{};
  for (FinePair& pair : pairs) {
    const auto c = static_cast<std::size_t>(pair.is_vertical);
    pair.weight = pair.is_held_out ? 0.0 : tukey(pair.residual_m, widths[c]);
    totals[c] += pair.weight;
  }
  // Equal total weight of facades and ground, whatever their numbers.
  const double facade_gain = totals[0] > 0.0 && totals[1] > 0.0 ? totals[0] / totals[1] : 1.0;
  Matrix7d normal = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
  for (FinePair& pair : pairs) {
    if (pair.is_vertical) pair.weight *= facade_gain;
    normal += pair.weight * pair.jacobian * pair.jacobian.transpose();
    right -= pair.weight * pair.residual_m * pair.jacobian;
  }
  horizontal_updated_ = sizes[1].size() >= static_cast<std::size_t>(options_.min_vertical_pairs);
  const auto hold = [&](Eigen::Index k) {
    normal.row(k).setZero();
    normal.col(k).setZero();
    normal(k, k) = 1.0;
    right[k] = 0.0;
  };
  if (!free_scale || !horizontal_updated_) hold(6);
  if (!horizontal_updated_) {
    for (const Eigen::Index k : {0, 1, 5}) hold(k);
  }
  const Eigen::LDLT<Matrix7d> solver(normal);
  if (solver.info() != Eigen::Success || !solver.isPositive()) return -1.0;
  const Vector7d update = solver.solve(right);
  if (!update.allFinite()) return -1.0;
  pose_ = apply_update(update, centre_, pose_);
  return update.head<3>().norm() + 30.0 * update.tail<4>().norm();
}

void FineProblem::converge(double gate_m, bool free_scale) {
  for (int k = 0; k < 12 && !ctx_.stopped(); ++k) {
    std::vector<FinePair> pairs = find_pairs(gate_m, 1);
    const double moved_m = step(pairs, gate_m, free_scale);
    if (moved_m < 2e-4) break;
  }
}

double plane_residual(const Eigen::Vector3d& moved,
                      const Eigen::Vector3d& on_plane,
                      const Eigen::Vector3d& normal,
                      const Eigen::Vector3d& centre,
                      Vector7d& jacobian) {
  const Eigen::Vector3d arm = moved - centre;
  jacobian << normal, arm.cross(normal), normal.dot(arm);
  return normal.dot(moved - on_plane);
}

Sim3 apply_update(const Vector7d& update,
                  const Eigen::Vector3d& centre,
                  const Sim3& target_from_source) {
  Sim3 change;
  const Eigen::Vector3d turn = update.segment<3>(3);
  if (turn.norm() > 0.0) {
    change.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
  }
  change.scale = std::exp(update[6]);
  change.translation = centre + update.head<3>() - change.scale * (change.rotation * centre);
  Sim3 result = change * target_from_source;
  result.rotation.normalize();
  return result;
}

}  // namespace hybridfusion
