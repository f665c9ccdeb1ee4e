#include "described_pair.hpp"
#include "patch_voting.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/registration/paper_registration.hpp>

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// A LiDAR patch with more than eta points and its candidates.
struct SelectedPatch {
  std::size_t grid = 0;
  std::size_t patch = 0;
  std::vector<PatchCandidate> candidates = {};
};

/// LiDAR patches with more than eta points with what is left of their candidates; one match each.
std::vector<SelectedPatch> select_patches(std::span<const PatchedCloud> grids,
                                          const PatchedCloud& vision,
                                          const Rigid3& vision_from_lidar_coarse,
                                          const PaperOptions& options,
                                          std::vector<PatchMatch>& matches) {
  const Eigen::Vector2d origin = vision_from_lidar_coarse.translation.head<2>();  // GNSS_origin
  std::vector<SelectedPatch> selected;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const PatchedCloud& lidar = grids[k];
    for (std::size_t p = 0; p < lidar.grid.patches.size(); ++p) {
      const Patch& patch = lidar.grid.patches[p];
      if (std::cmp_less_equal(patch.indices.size(), options.min_patch_points)) continue;
      PatchMatch match{.lidar_cell = patch.cell,
                       .centroid_in_vision = patch.centroid,
                       .num_points = patch.indices.size(),
                       .vision_from_lidar = vision_from_lidar_coarse};
      selected.push_back({k, p, match_patch(p, lidar, vision, origin, options, match)});
      matches.push_back(match);
    }
  }
  return selected;
}

/// Boundaries of all vision patches that are a candidate of some LiDAR patch.
BoundaryTargets make_targets(std::span<const SelectedPatch> selected,
                             const PatchedCloud& vision,
                             const PaperOptions& options,
                             const RunContext& ctx) {
  BoundaryTargets targets(vision.grid.patches.size());
  std::vector<bool> needed(targets.size(), false);
  for (const SelectedPatch& s : selected) {
    for (const PatchCandidate& c : s.candidates) needed[c.vision_patch] = true;
  }
  parallel_for(ctx, targets.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last && !ctx.stopped(); ++p) {
      if (!needed[p]) continue;
      auto boundary =
          splice_boundary(vision.points, vision.heights, vision.grid, p, options.boundary);
      if (std::ssize(boundary) < options.min_boundary_points) continue;
      targets[p] = std::make_unique<BoundaryTarget>(std::move(boundary));
    }
  });
  return targets;
}

/// Algorithm 1 for every selected patch. @returns kCancelled when stopped.
Expected<void> register_selected(std::span<const SelectedPatch> selected,
                                 std::span<const PatchedCloud> grids,
                                 const PatchedCloud& vision,
                                 const PaperOptions& options,
                                 const NdtOptions& ndt,
                                 const RunContext& ctx,
                                 std::vector<PatchMatch>& matches) {
  const auto count = static_cast<std::int64_t>(selected.size());
  ctx.report({.stage = "registration/paper/patches", .total = count});
  const BoundaryTargets targets = make_targets(selected, vision, options, ctx);
  parallel_for(ctx, selected.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && !ctx.stopped(); ++i) {
      const SelectedPatch& chosen = selected[i];
      if (chosen.candidates.empty()) continue;
      register_patch(chosen.patch,
                     chosen.candidates,
                     grids[chosen.grid],
                     vision,
                     targets,
                     options,
                     ndt,
                     matches[i]);
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while registering patches");
  ctx.report({.stage = "registration/paper/patches", .done = count, .total = count});
  return {};
}

/// "Minor adjustments" by 3D NDT of the whole clouds (III-C.5): one that leaves the cluster is not
/// minor and is not taken.
Expected<void> adjust(const PatchedCloud& vision,
                      const PatchedCloud& lidar,
                      const Rigid3& vision_from_lidar_coarse,
                      const Eigen::Vector3d& lidar_centroid,
                      const PaperOptions& options,
                      const NdtOptions& ndt,
                      const RunContext& ctx,
                      PaperResult& result) {
  const Rigid3& mean = result.vision_from_lidar;
  const Rigid3 start = mean * vision_from_lidar_coarse.inverse();
  const auto samples = static_cast<std::size_t>(ndt.samples);
  const auto spatial = refine_ndt_3d(vision.points, lidar.points, start, samples, ndt, ctx);
  if (!spatial && spatial.error().code == ErrorCode::kCancelled) {
    return std::unexpected(spatial.error());
  }
  if (!spatial || !spatial->quality.converged) {
    result.reason = "the final 3D NDT did not converge; the mean of the patch poses is kept";
    return {};
  }
  const Rigid3 end = spatial->target_from_source * vision_from_lidar_coarse;
  const double gap_m = (end * lidar_centroid - mean * lidar_centroid).norm();
  const double gap_rad = rotation_distance_rad(end.rotation, mean.rotation);
  if (gap_m >= options.cluster_radius_m || gap_rad >= options.cluster_angle_rad) {
    result.reason = fmt::format(
        "the final 3D NDT left the patch poses by {:.2f} m and {:.3f} rad; "
        "their mean is kept",
        gap_m,
        gap_rad);
    return {};
  }
  result.vision_from_lidar = end;
  result.adjusted = true;
  return {};
}

Eigen::Vector3d centroid_of(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) sum += p.cast<double>();
  return sum / static_cast<double>(points.size());
}

}  // namespace

Expected<PaperResult> register_by_patches(const GroundedCloud& vision,
                                          const GroundedCloud& lidar,
                                          const Rigid3& vision_from_lidar_coarse,
                                          const PaperOptions& options,
                                          const NdtOptions& ndt,
                                          const RunContext& ctx) {
  HF_CHECK(vision.points.size() == vision.heights.size());
  HF_CHECK(lidar.points.size() == lidar.heights.size());
  if (vision.points.empty() || lidar.points.empty()) {
    return fail(ErrorCode::kInsufficient, "a cloud without points cannot be registered");
  }
  HF_TRY(const DescribedPair pair,
         describe_pair(vision, lidar, vision_from_lidar_coarse, options, ctx));
  const PatchedCloud& g = pair.vision;
  const std::vector<PatchedCloud>& grids = pair.lidar;

  PaperResult result{.vision_from_lidar = vision_from_lidar_coarse};
  const std::vector<SelectedPatch> selected =
      select_patches(grids, g, vision_from_lidar_coarse, options, result.patches);
  if (const auto done = register_selected(selected, grids, g, options, ndt, ctx, result.patches);
      !done) {
    return std::unexpected(done.error());
  }
  const Eigen::Vector3d lidar_centroid = centroid_of(lidar.points);
  cluster_poses(lidar_centroid, options, result);
  if (!result.supported) return result;
  const auto adjusted =
      adjust(g, grids.front(), vision_from_lidar_coarse, lidar_centroid, options, ndt, ctx, result);
  if (!adjusted) return std::unexpected(adjusted.error());
  return result;
}

}  // namespace hybridfusion
