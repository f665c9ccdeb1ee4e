#include "fine_alignment.hpp"

#include "fine_statistics.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

double tukey(double residual, double width) {
  const double ratio = residual / width;
  return std::abs(ratio) < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
}

/// One alignment in progress: the clouds, the samples, the current similarity.
class FineProblem {
 public:
  FineProblem(FineInputs& inputs,
              const Rigid3& start,
              const FineOptions& options,
              const RunContext& ctx)
      : options_(options),
        ctx_(ctx),
        planes_(inputs.planes),
        samples_(inputs.samples),
        pose_{.rotation = start.rotation, .translation = start.translation} {}

  /// Pairs within `gate_m` of every `stride`-th sample; also counts the samples near the cloud.
  std::vector<FinePair> find_pairs(double gate_m, std::size_t stride);
  /// One Gauss-Newton step. @returns the length of the update, or a negative number when singular.
  double step(std::vector<FinePair>& pairs, double gate_m, bool free_scale);
  void converge(double gate_m, bool free_scale);

  Sim3& pose() { return pose_; }
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] bool horizontal_updated() const { return horizontal_updated_; }
  [[nodiscard]] double held_out_near() const { return held_out_near_; }
  [[nodiscard]] std::size_t num_samples() const { return samples_.size(); }

 private:
  const FineOptions& options_;
  const RunContext& ctx_;
  LazyPlanes& planes_;
  const std::vector<FineSample>& samples_;
  Sim3 pose_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  bool horizontal_updated_ = false;
  double held_out_near_ = 0.0;
};

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

void estimate_scale(FineProblem& problem,
                    const Eigen::Vector3d& lidar_centroid,
                    double gate_m,
                    const FineOptions& options,
                    FineResult& result) {
  // A scale of 1 % moves the ends of the scene by half a metre: open the gate for it.
  problem.converge(2.0 * gate_m, true);
  problem.converge(gate_m, true);
  std::vector<FinePair> pairs = problem.find_pairs(gate_m, 1);
  problem.step(pairs, gate_m, true);
  const Matrix7d covariance = jackknife_covariance(pairs, true);
  result.similarity = problem.pose();
  result.scale_sigma =
      std::hypot(std::sqrt(std::max(0.0, covariance(6, 6))), systematic_scale_sigma(pairs));
  const double offset = std::abs(result.similarity.scale - 1.0);
  result.scale_supported = offset <= options.max_scale_error && offset > 3.0 * result.scale_sigma;
  if (!result.scale_supported) return;
  fill_statistics(pairs, problem.held_out_near(), result);
  result.vision_from_lidar.rotation = result.similarity.rotation;
  result.vision_from_lidar.translation =
      result.similarity * lidar_centroid - result.similarity.rotation * lidar_centroid;
  result.covariance = tangent_covariance(covariance, result.vision_from_lidar, problem.centre());
}

/// Where the shrinking gate ends: wide enough for the facades as they lie. A LiDAR map with drift
/// shows them in several places; a narrow gate would settle on one of these at random.
double settled_gate(FineProblem& problem, const FineOptions& options) {
  const double wide_m = std::max(options.final_gate_m, std::min(1.0, options.start_gate_m));
  problem.converge(wide_m, false);
  std::vector<double> sizes;
  for (const FinePair& pair : problem.find_pairs(wide_m, 1)) {
    if (pair.is_vertical) sizes.push_back(std::abs(pair.residual_m));
  }
  return std::clamp(2.5 * quantile(std::move(sizes), 0.8), options.final_gate_m, wide_m);
}

}  // namespace

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

Expected<FineResult> align_fine(FineInputs& inputs,
                                const Rigid3& start,
                                const Eigen::Vector3d& lidar_centroid,
                                const FineOptions& options,
                                const RunContext& ctx) {
  constexpr std::size_t kMinPairs = 100;
  FineProblem problem(inputs, start, options, ctx);
  const auto too_few = [&](std::size_t count, double gate_m) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} of {} LiDAR samples meet a plane of the vision cloud within "
                            "{:.2f} m, at least {} are needed",
                            count,
                            problem.num_samples(),
                            gate_m,
                            kMinPairs));
  };
  // The first steps only have to come near: a third of the samples does.
  const double near_m = std::min(1.0, options.start_gate_m);
  for (int k = 0; k < options.iterations && !ctx.stopped(); ++k) {
    const double progress = k / (options.iterations - 1.0);
    const double gate = options.start_gate_m * std::pow(near_m / options.start_gate_m, progress);
    std::vector<FinePair> pairs = problem.find_pairs(gate, 3);
    if (pairs.size() < kMinPairs / 3 || problem.step(pairs, gate, false) < 0.0) {
      return too_few(3 * pairs.size(), gate);
    }
  }
  const double gate_m = settled_gate(problem, options);
  for (double gate = near_m; gate > gate_m && !ctx.stopped(); gate *= 0.8) {
    std::vector<FinePair> pairs = problem.find_pairs(gate, 1);
    problem.step(pairs, gate, false);
  }
  problem.converge(gate_m, false);
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped in the fine alignment");
  std::vector<FinePair> pairs = problem.find_pairs(gate_m, 1);
  if (pairs.size() < kMinPairs) return too_few(pairs.size(), gate_m);
  problem.step(pairs, gate_m, false);
  FineResult result;
  result.horizontal_updated = problem.horizontal_updated();
  result.similarity = problem.pose();
  result.vision_from_lidar = {.rotation = problem.pose().rotation,
                              .translation = problem.pose().translation};
  fill_statistics(pairs, problem.held_out_near(), result);
  result.gate_m = gate_m;
  result.covariance = tangent_covariance(
      jackknife_covariance(pairs, false), result.vision_from_lidar, problem.centre());
  if (options.estimate_scale && result.horizontal_updated) {
    estimate_scale(problem, lidar_centroid, gate_m, options, result);
  }
  return result;
}

}  // namespace hybridfusion
