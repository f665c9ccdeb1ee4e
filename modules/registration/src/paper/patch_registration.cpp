#include "patch_registration.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/registration/neighbour_filter.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybridfusion {
namespace {

constexpr std::size_t kPatchSamples = 2000;  // points of a patch that its 3D NDT looks at

std::vector<Eigen::Vector3f> points_at(std::span<const Eigen::Vector3f> points,
                                       std::span<const std::uint32_t> indices) {
  std::vector<Eigen::Vector3f> selected;
  selected.reserve(indices.size());
  for (const std::uint32_t i : indices) selected.push_back(points[i]);
  return selected;
}

/// The planar motion as a motion in space; heights stay.
Rigid3 lifted(const Rigid2& motion) {
  return {
      .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(motion.yaw_rad, Eigen::Vector3d::UnitZ())),
      .translation = {motion.translation.x(), motion.translation.y(), 0.0}};
}

constexpr float kOverlapGate_m = 0.5F;

/// Share of the points of `indices` above `above_m` that lie near the target; 1 when none is high.
double high_overlap(const PatchedCloud& lidar,
                    std::span<const std::uint32_t> indices,
                    double above_m,
                    const KdTree& target,
                    const Rigid3& target_from_source) {
  std::size_t high = 0;
  std::size_t near = 0;
  for (const std::uint32_t i : indices) {
    if (static_cast<double>(lidar.heights[i]) < above_m) continue;
    ++high;
    const Eigen::Vector3d moved = target_from_source * lidar.points[i].cast<double>();
    const float squared_m2 = target.nearest(moved.cast<float>()).squared_distance_m2;
    if (squared_m2 < kOverlapGate_m * kOverlapGate_m) ++near;
  }
  return high == 0 ? 1.0 : static_cast<double>(near) / static_cast<double>(high);
}

double median_distance_m(std::span<const Eigen::Vector3f> source,
                         const KdTree& target,
                         const Rigid3& target_from_source) {
  std::vector<float> squared;
  squared.reserve(source.size());
  for (const Eigen::Vector3f& p : source) {
    const Eigen::Vector3d moved = target_from_source * p.cast<double>();
    squared.push_back(target.nearest(moved.cast<float>()).squared_distance_m2);
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return std::sqrt(static_cast<double>(*middle));
}

Eigen::Vector3d mean_of(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) sum += p.cast<double>();
  return sum / static_cast<double>(points.size());
}

struct BestCandidate {
  PatchCandidate candidate = {};
  BoundaryMatch match = {};
};

/// Algorithm 1, lines 4 to 13: the candidate with the smallest 2D score.
std::optional<BestCandidate> best_in_2d(std::span<const Eigen::Vector2f> boundary,
                                        std::span<const PatchCandidate> candidates,
                                        const BoundaryTargets& targets,
                                        const PaperOptions& options) {
  std::optional<BestCandidate> best;
  for (const PatchCandidate& candidate : candidates) {
    const auto& target = targets[candidate.vision_patch];
    if (!target) continue;
    const auto match = align_boundaries_2d(boundary, *target, options);
    if (!match) continue;
    if (!best || match->mean_distance_m < best->match.mean_distance_m) best = {candidate, *match};
  }
  return best;
}

}  // namespace

Expected<Ndt3Result> refine_ndt_3d(std::span<const Eigen::Vector3f> target,
                                   std::span<const Eigen::Vector3f> source,
                                   const Rigid3& start,
                                   std::size_t samples,
                                   const NdtOptions& options,
                                   const RunContext& ctx) {
  const std::size_t count = std::min(source.size(), samples);
  std::vector<Eigen::Vector3f> thinned;
  thinned.reserve(count);
  for (std::size_t k = 0; k < count; ++k) thinned.push_back(source[k * source.size() / count]);
  return align_ndt_3d(target,
                      thinned,
                      start,
                      {.cell_m = options.final_cell_m,
                       .min_cell_points = options.min_cell_points,
                       .outlier_ratio = options.outlier_ratio,
                       .max_iterations = options.iterations},
                      ctx);
}

PaperImprovements changes_of(const PaperOptions& options) {
  if (options.variant == "improved") return options.improved;
  return {.half_step_patches = false,
          .describe_spliced = false,
          .describe_above_m = 0.0,
          .best_candidates = 0,
          .min_overlap = 0.0};
}

Expected<PatchSignatures> describe_patches(std::span<const Eigen::Vector3f> points,
                                           std::span<const float> heights,
                                           const PatchGrid& grid,
                                           const PaperOptions& options,
                                           const RunContext& ctx) {
  PatchSignatures signatures(grid.patches.size());
  const auto least = static_cast<std::size_t>(options.min_neighbour_points);
  const PaperImprovements changes = changes_of(options);
  const auto low = [&](std::uint32_t i) {
    return static_cast<double>(heights[i]) < changes.describe_above_m;
  };
  parallel_for(ctx, grid.patches.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last && !ctx.stopped(); ++p) {
      std::vector<std::uint32_t> members =
          changes.describe_spliced ? splice_neighbours(grid, p) : grid.patches[p].indices;
      if (changes.describe_above_m > 0.0) std::erase_if(members, low);
      if (members.size() < least) continue;
      const auto signature = compute_esf(points_at(points, members),
                                         {.samples = options.esf_samples, .seed = ctx.seed});
      // A patch that spans no plane has no shape to compare: it stays undescribed.
      if (signature) signatures[p] = centre_signature(*signature);
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while describing patches");
  return signatures;
}

std::vector<PatchCandidate> match_patch(std::size_t patch,
                                        const PatchedCloud& lidar,
                                        const PatchedCloud& vision,
                                        const Eigen::Vector2d& origin,
                                        const PaperOptions& options,
                                        PatchMatch& match) {
  const CandidateRing ring{.ring_ratio = options.ring_ratio,
                           .max_bearing_rad = options.max_bearing_rad};
  const Eigen::Vector2d centroid = lidar.grid.patches[patch].centroid.head<2>();
  const auto selected = select_candidates(centroid, origin, vision.grid, vision.points, ring);
  match.num_candidates = selected.size();
  match.outcome = PatchOutcome::kNoCandidate;
  if (selected.empty() || !lidar.signatures[patch]) return {};
  if (const int count = changes_of(options).best_candidates; count > 0) {
    auto best = best_by_correlation(
        *lidar.signatures[patch], selected, vision.signatures, static_cast<std::size_t>(count));
    match.num_correlated = match.num_similar = best.size();
    match.outcome = best.empty() ? PatchOutcome::kNoCorrelation : PatchOutcome::kNoBoundary;
    return best;
  }
  const auto correlated = filter_by_correlation(
      *lidar.signatures[patch], selected, vision.signatures, options.min_correlation);
  match.num_correlated = correlated.size();
  match.outcome = PatchOutcome::kNoCorrelation;
  if (correlated.empty()) return {};
  auto similar = filter_by_neighbours(patch,
                                      correlated,
                                      lidar.grid,
                                      lidar.signatures,
                                      vision.grid,
                                      vision.signatures,
                                      static_cast<std::size_t>(options.min_neighbour_points),
                                      options.min_neighbour_score);
  match.num_similar = similar.size();
  match.outcome = similar.empty() ? PatchOutcome::kNoNeighbours : PatchOutcome::kNoBoundary;
  return similar;
}

void register_patch(std::size_t patch,
                    std::span<const PatchCandidate> candidates,
                    const PatchedCloud& lidar,
                    const PatchedCloud& vision,
                    const BoundaryTargets& targets,
                    const PaperOptions& options,
                    const NdtOptions& ndt,
                    PatchMatch& match) {
  const auto boundary =
      splice_boundary(lidar.points, lidar.heights, lidar.grid, patch, options.boundary);
  if (std::ssize(boundary) < options.min_boundary_points) return;
  const auto best = best_in_2d(boundary, candidates, targets, options);
  if (!best) return;
  match.vision_cell = vision.grid.patches[best->candidate.vision_patch].cell;
  match.correlation = best->candidate.correlation;
  match.neighbour_score = best->candidate.neighbour_score;
  match.score_2d_m = best->match.mean_distance_m;
  match.outcome = PatchOutcome::kRejected3d;

  // Algorithm 1, lines 14 to 19.
  const auto members = splice_neighbours(lidar.grid, patch);
  const auto source = points_at(lidar.points, members);
  const auto target =
      points_at(vision.points, splice_neighbours(vision.grid, best->candidate.vision_patch));
  const Rigid3 planar = lifted(best->match.target_from_source);
  match.vision_from_lidar_2d = planar * match.vision_from_lidar;
  const auto spatial =
      refine_ndt_3d(target, source, planar, kPatchSamples, ndt, {.num_threads = 1});
  if (!spatial) return;
  const Rigid3& refined = spatial->target_from_source;
  const KdTree tree(target);
  match.score_3d_m = median_distance_m(source, tree, refined);
  const Eigen::Vector3d middle = mean_of(source);
  const double shift_m = (refined * middle - planar * middle).head<2>().norm();
  if (!spatial->quality.converged || shift_m > options.ndt3_max_shift_m ||
      match.score_3d_m > options.max_score_3d_m) {
    return;
  }
  const PaperImprovements changes = changes_of(options);
  if (changes.min_overlap > 0.0 &&
      high_overlap(lidar, members, changes.describe_above_m, tree, refined) < changes.min_overlap) {
    return;
  }
  match.outcome = PatchOutcome::kPose;
  match.vision_from_lidar = refined * match.vision_from_lidar;
}

}  // namespace hybridfusion
