#include "fine_alignment.hpp"

#include "fine_samples.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct Pair {
  std::size_t sample = 0;
  double residual_m = 0.0;
  Vector7d jacobian = Vector7d::Zero();
  double weight = 0.0;  ///< Of the last step.
  bool is_vertical = false;
  bool is_held_out = false;
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

double tukey(double residual, double width) {
  const double ratio = residual / width;
  return std::abs(ratio) < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
}

/// One alignment in progress: the clouds, the samples, the current similarity.
class FineProblem {
 public:
  FineProblem(std::span<const Eigen::Vector3f> vision,
              std::span<const Eigen::Vector3f> lidar,
              const Rigid3& start,
              const FineOptions& options,
              const RunContext& ctx)
      : vision_(vision),
        options_(options),
        ctx_(ctx),
        planes_(vision, options, ctx),
        samples_(draw_samples(vision, lidar, start, options, ctx)),
        pose_{.rotation = start.rotation, .translation = start.translation} {}

  /// Pairs within `gate_m` of every `stride`-th sample; also counts the samples near the cloud.
  std::vector<Pair> find_pairs(double gate_m, std::size_t stride);
  /// One Gauss-Newton step. @returns the length of the update, or a negative number when singular.
  double step(std::vector<Pair>& pairs, double gate_m, bool free_scale);
  void converge(double gate_m, bool free_scale);

  Sim3& pose() { return pose_; }
  [[nodiscard]] const Eigen::Vector3d& centre() const { return centre_; }
  [[nodiscard]] bool horizontal_updated() const { return horizontal_updated_; }
  [[nodiscard]] double held_out_near() const { return held_out_near_; }
  [[nodiscard]] const FineSample& sample(std::size_t i) const { return samples_[i]; }
  [[nodiscard]] std::size_t num_samples() const { return samples_.size(); }

 private:
  std::span<const Eigen::Vector3f> vision_;
  const FineOptions& options_;
  const RunContext& ctx_;
  LazyPlanes planes_;
  std::vector<FineSample> samples_;
  Sim3 pose_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  bool horizontal_updated_ = false;
  double held_out_near_ = 0.0;
};

std::vector<Pair> FineProblem::find_pairs(double gate_m, std::size_t stride) {
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
  std::vector<Pair> pairs;
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
    Pair pair{
        .sample = k * stride, .is_vertical = sample.is_vertical, .is_held_out = sample.is_held_out};
    pair.residual_m =
        plane_residual(moved[k], plane.mean.cast<double>(), normal, centre_, pair.jacobian);
    if (std::abs(pair.residual_m) < gate_m) pairs.push_back(pair);
  }
  return pairs;
}

double FineProblem::step(std::vector<Pair>& pairs, double gate_m, bool free_scale) {
  std::array<std::vector<double>, 2> sizes;
  for (const Pair& pair : pairs) sizes[pair.is_vertical].push_back(std::abs(pair.residual_m));
  std::array<double, 2> widths{};
  for (std::size_t c = 0; c < 2; ++c) {
    widths[c] = std::clamp(6.0 * quantile(sizes[c], 0.5), 0.03, gate_m);
  }
  std::array<double, 2> totals{};
  for (Pair& pair : pairs) {
    const auto c = static_cast<std::size_t>(pair.is_vertical);
    pair.weight = pair.is_held_out ? 0.0 : tukey(pair.residual_m, widths[c]);
    totals[c] += pair.weight;
  }
  // Equal total weight of facades and ground, whatever their numbers.
  const double facade_gain = totals[0] > 0.0 && totals[1] > 0.0 ? totals[0] / totals[1] : 1.0;
  Matrix7d normal = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
  for (Pair& pair : pairs) {
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
    std::vector<Pair> pairs = find_pairs(gate_m, 1);
    const double moved_m = step(pairs, gate_m, free_scale);
    if (moved_m < 2e-4) break;
  }
}

void fill_statistics(const std::vector<Pair>& pairs, FineProblem& problem, FineResult& result) {
  std::vector<double> held_out;
  std::array<double, 2> squares{};
  std::array<double, 2> counts{};
  for (const Pair& pair : pairs) {
    const auto c = static_cast<std::size_t>(pair.is_vertical);
    squares[c] += pair.residual_m * pair.residual_m;
    counts[c] += 1.0;
    if (pair.is_held_out) held_out.push_back(std::abs(pair.residual_m));
  }
  result.num_horizontal = static_cast<std::size_t>(counts[0]);
  result.num_vertical = static_cast<std::size_t>(counts[1]);
  result.horizontal_rms_m = std::sqrt(squares[0] / std::max(1.0, counts[0]));
  result.vertical_rms_m = std::sqrt(squares[1] / std::max(1.0, counts[1]));
  result.held_out_share =
      static_cast<double>(held_out.size()) / std::max(1.0, problem.held_out_near());
  result.held_out_median_m = quantile(std::move(held_out), 0.5);
}

/// Covariance over [v; w; s] about the centre by leaving out one block of the scene at a time
/// (Quenouille's jackknife): errors of one facade, of drift and of doming are shared by neighbours,
/// so that single residuals say too little about the pose.
Matrix7d jackknife_covariance(const std::vector<Pair>& pairs,
                              const FineProblem& problem,
                              bool free_scale) {
  constexpr double kBlocksAcross = 6.0;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = -low;
  for (const Pair& pair : pairs) {
    low = low.cwiseMin(problem.sample(pair.sample).point.head<2>());
    high = high.cwiseMax(problem.sample(pair.sample).point.head<2>());
  }
  const double side_m = std::max(2.0, (high - low).maxCoeff() / kBlocksAcross);
  std::map<std::pair<int, int>, std::pair<Matrix7d, Vector7d>> blocks;
  Matrix7d normal = Matrix7d::Identity() * 1e-6;
  Vector7d right = Vector7d::Zero();
  for (const Pair& pair : pairs) {
    const Eigen::Vector2d cell = (problem.sample(pair.sample).point.head<2>() - low) / side_m;
    auto& [block_normal, block_right] =
        blocks
            .try_emplace({static_cast<int>(cell.x()), static_cast<int>(cell.y())},
                         Matrix7d::Zero(),
                         Vector7d::Zero())
            .first->second;
    block_normal += pair.weight * pair.jacobian * pair.jacobian.transpose();
    block_right -= pair.weight * pair.residual_m * pair.jacobian;
  }
  for (const auto& [cell, block] : blocks) {
    normal += block.first;
    right += block.second;
  }
  const auto count = static_cast<double>(blocks.size());
  const Eigen::Index free = free_scale ? 7 : 6;
  std::vector<Vector7d> updates;
  Vector7d mean = Vector7d::Zero();
  for (const auto& [cell, block] : blocks) {
    Vector7d update = Vector7d::Zero();
    update.head(free) = (normal - block.first)
                            .topLeftCorner(free, free)
                            .ldlt()
                            .solve((right - block.second).head(free));
    updates.push_back(update);
    mean += update / count;
  }
  Matrix7d covariance = Matrix7d::Zero();
  for (const Vector7d& update : updates) {
    covariance += (count - 1.0) / count * (update - mean) * (update - mean).transpose();
  }
  return covariance;
}

Matrix6d tangent_covariance(const Matrix7d& centred,
                            const Rigid3& pose,
                            const Eigen::Vector3d& centre) {
  // [v; w] about the centre to the right perturbation: rho = R^T (v + (c - t) x w), phi = R^T w.
  const Eigen::Matrix3d back = pose.rotation.toRotationMatrix().transpose();
  const Eigen::Vector3d arm = centre - pose.translation;
  Eigen::Matrix3d cross;
  cross << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
  Matrix6d map = Matrix6d::Zero();
  map.topLeftCorner<3, 3>() = back;
  map.topRightCorner<3, 3>() = back * cross;
  map.bottomRightCorner<3, 3>() = back;
  return map * centred.topLeftCorner<6, 6>() * map.transpose();
}

/// Stereo moves all facades outward or inward by a centimetre or so, which looks like a scale.
double systematic_scale_sigma(const std::vector<Pair>& pairs, FineProblem& problem) {
  constexpr double kFacadeBias_m = 0.01;
  double squares = 0.0;
  double count = 0.0;
  for (const Pair& pair : pairs) {
    if (!pair.is_vertical) continue;
    const Eigen::Vector3d p = problem.pose() * problem.sample(pair.sample).point;
    squares += (p - problem.centre()).head<2>().squaredNorm();
    count += 1.0;
  }
  return kFacadeBias_m / std::max(1.0, std::sqrt(squares / std::max(1.0, count)));
}

void estimate_scale(FineProblem& problem,
                    const Eigen::Vector3d& lidar_centroid,
                    double gate_m,
                    const FineOptions& options,
                    FineResult& result) {
  // A scale of 1 % moves the ends of the scene by half a metre: open the gate for it.
  problem.converge(2.0 * gate_m, true);
  problem.converge(gate_m, true);
  std::vector<Pair> pairs = problem.find_pairs(gate_m, 1);
  problem.step(pairs, gate_m, true);
  const Matrix7d covariance = jackknife_covariance(pairs, problem, true);
  result.similarity = problem.pose();
  result.scale_sigma = std::hypot(std::sqrt(std::max(0.0, covariance(6, 6))),
                                  systematic_scale_sigma(pairs, problem));
  const double offset = std::abs(result.similarity.scale - 1.0);
  result.scale_supported = offset <= options.max_scale_error && offset > 3.0 * result.scale_sigma;
  if (!result.scale_supported) return;
  fill_statistics(pairs, problem, result);
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
  for (const Pair& pair : problem.find_pairs(wide_m, 1)) {
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

Expected<FineResult> align_fine(std::span<const Eigen::Vector3f> vision,
                                std::span<const Eigen::Vector3f> lidar,
                                const Rigid3& start,
                                const Eigen::Vector3d& lidar_centroid,
                                const FineOptions& options,
                                const RunContext& ctx) {
  constexpr std::size_t kMinPairs = 100;
  FineProblem problem(vision, lidar, start, options, ctx);
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
    std::vector<Pair> pairs = problem.find_pairs(gate, 3);
    if (pairs.size() < kMinPairs / 3 || problem.step(pairs, gate, false) < 0.0) {
      return too_few(3 * pairs.size(), gate);
    }
  }
  const double gate_m = settled_gate(problem, options);
  for (double gate = near_m; gate > gate_m && !ctx.stopped(); gate *= 0.8) {
    std::vector<Pair> pairs = problem.find_pairs(gate, 1);
    problem.step(pairs, gate, false);
  }
  problem.converge(gate_m, false);
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped in the fine alignment");
  std::vector<Pair> pairs = problem.find_pairs(gate_m, 1);
  if (pairs.size() < kMinPairs) return too_few(pairs.size(), gate_m);
  problem.step(pairs, gate_m, false);
  FineResult result;
  result.horizontal_updated = problem.horizontal_updated();
  result.similarity = problem.pose();
  result.vision_from_lidar = {.rotation = problem.pose().rotation,
                              .translation = problem.pose().translation};
  fill_statistics(pairs, problem, result);
  result.gate_m = gate_m;
  result.covariance = tangent_covariance(
      jackknife_covariance(pairs, problem, false), result.vision_from_lidar, problem.centre());
  if (options.estimate_scale && result.horizontal_updated) {
    estimate_scale(problem, lidar_centroid, gate_m, options, result);
  }
  return result;
}

}  // namespace hybridfusion
