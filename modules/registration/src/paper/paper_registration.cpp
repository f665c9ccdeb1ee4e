#include "isolated_points.hpp"
#include "patch_registration.hpp"
#include "patch_voting.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/registration/paper_registration.hpp>

#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// A cloud of its own without isolated points, in vision.
struct CleanCloud {
  std::vector<Eigen::Vector3f> points = {};
  std::vector<float> heights = {};
};

CleanCloud cleaned(const GroundedCloud& cloud,
                   const Rigid3& vision_from_cloud,
                   const PaperOptions& options) {
  CleanCloud clean;
  for (const std::uint32_t i :
       supported_points(cloud.points, options.isolation_cell_m, options.min_supporting_points)) {
    clean.points.emplace_back((vision_from_cloud * cloud.points[i].cast<double>()).cast<float>());
    clean.heights.push_back(cloud.heights[i]);
  }
  return clean;
}

Expected<PatchedCloud> cut_into_patches(const CleanCloud& clean,
                                        double step_m,
                                        const PaperOptions& options,
                                        const RunContext& ctx) {
  PatchedCloud cloud{.points = clean.points, .heights = clean.heights};
  HF_TRY(cloud.grid, grid_into_patches(cloud.points, step_m, options.cut_share));
  HF_TRY(cloud.signatures, describe_patches(cloud.points, cloud.grid, options, ctx));
  return cloud;
}

/// A LiDAR patch with more than eta points and its candidates.
struct SelectedPatch {
  std::size_t patch = 0;
  std::vector<PatchCandidate> candidates = {};
};

/// LiDAR patches with more than eta points with what is left of their candidates; one match each.
std::vector<SelectedPatch> select_patches(const PatchedCloud& lidar,
                                          const PatchedCloud& vision,
                                          const Rigid3& vision_from_lidar_coarse,
                                          const PaperOptions& options,
                                          std::vector<PatchMatch>& matches) {
  const Eigen::Vector2d origin = vision_from_lidar_coarse.translation.head<2>();  // GNSS_origin
  std::vector<SelectedPatch> selected;
  for (std::size_t p = 0; p < lidar.grid.patches.size(); ++p) {
    const Patch& patch = lidar.grid.patches[p];
    if (std::cmp_less_equal(patch.indices.size(), options.min_patch_points)) continue;
    PatchMatch match{.lidar_cell = patch.cell,
                     .centroid_in_vision = patch.centroid,
                     .num_points = patch.indices.size(),
                     .vision_from_lidar = vision_from_lidar_coarse};
    selected.push_back({p, match_patch(p, lidar, vision, origin, options, match)});
    matches.push_back(match);
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
  const CleanCloud clean_vision = cleaned(vision, Rigid3{}, options);
  const CleanCloud clean_lidar = cleaned(lidar, vision_from_lidar_coarse, options);
  const double step_m =
      scene_size_m(clean_vision.points, options.cut_share) / options.grid_divisions;  // III-C.1
  if (!(step_m > 0.0)) {
    return fail(ErrorCode::kDegenerate, "the vision cloud has no extent in x and y");
  }
  ctx.report({.stage = "registration/paper/describe", .total = 2});
  HF_TRY(const PatchedCloud g, cut_into_patches(clean_vision, step_m, options, ctx));
  ctx.report({.stage = "registration/paper/describe", .done = 1, .total = 2});
  HF_TRY(const PatchedCloud l, cut_into_patches(clean_lidar, step_m, options, ctx));

  PaperResult result{.vision_from_lidar = vision_from_lidar_coarse};
  const std::vector<SelectedPatch> selected =
      select_patches(l, g, vision_from_lidar_coarse, options, result.patches);
  const auto count = static_cast<std::int64_t>(selected.size());
  ctx.report({.stage = "registration/paper/patches", .total = count});
  const BoundaryTargets targets = make_targets(selected, g, options, ctx);
  parallel_for(ctx, selected.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && !ctx.stopped(); ++i) {
      if (selected[i].candidates.empty()) continue;
      register_patch(selected[i].patch,
                     selected[i].candidates,
                     l,
                     g,
                     targets,
                     options,
                     ndt,
                     result.patches[i]);
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while registering patches");
  ctx.report({.stage = "registration/paper/patches", .done = count, .total = count});
  const Eigen::Vector3d lidar_centroid = centroid_of(lidar.points);
  cluster_poses(lidar_centroid, options, result);
  if (!result.supported) return result;
  const auto adjusted =
      adjust(g, l, vision_from_lidar_coarse, lidar_centroid, options, ndt, ctx, result);
  if (!adjusted) return std::unexpected(adjusted.error());
  return result;
}

}  // namespace hybridfusion
