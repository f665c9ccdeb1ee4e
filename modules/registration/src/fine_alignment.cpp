#include "fine_alignment.hpp"

#include "fine_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

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
