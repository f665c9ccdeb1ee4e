#pragma once

#include "boundary_alignment.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/paper_registration.hpp>
#include <hybridfusion/registration/patch_candidates.hpp>

#include <memory>
#include <span>
#include <vector>

namespace hybridfusion {

/// One of the two clouds, cut into described patches. Coordinates are in vision (the LiDAR cloud by
/// the coarse pose).
struct PatchedCloud {
  std::span<const Eigen::Vector3f> points = {};
  std::span<const float> heights = {};
  PatchGrid grid = {};
  PatchSignatures signatures = {};
};

/// The changes in effect: none for the published variant.
[[nodiscard]] PaperImprovements changes_of(const PaperOptions& options);

/// @param heights  Above ground [m], one per point.
/// @returns kCancelled when stopped.
[[nodiscard]] Expected<PatchSignatures> describe_patches(std::span<const Eigen::Vector3f> points,
                                                         std::span<const float> heights,
                                                         const PatchGrid& grid,
                                                         const PaperOptions& options,
                                                         const RunContext& ctx);

/// The candidates of one LiDAR patch after all filters; notes in `match` how many each one left.
[[nodiscard]] std::vector<PatchCandidate> match_patch(std::size_t patch,
                                                      const PatchedCloud& lidar,
                                                      const PatchedCloud& vision,
                                                      const Eigen::Vector2d& origin,
                                                      const PaperOptions& options,
                                                      PatchMatch& match);

/// Boundary targets by vision patch; null where there are too few boundary points or no need.
using BoundaryTargets = std::vector<std::unique_ptr<BoundaryTarget>>;

/// 3D NDT with the final cell of `options` from a start that is good to about that cell, on at most
/// `samples` evenly spread source points. Errors as of align_ndt_3d.
[[nodiscard]] Expected<Ndt3Result> refine_ndt_3d(std::span<const Eigen::Vector3f> target,
                                                 std::span<const Eigen::Vector3f> source,
                                                 const Rigid3& start,
                                                 std::size_t samples,
                                                 const NdtOptions& options,
                                                 const RunContext& ctx);

/// Algorithm 1 for one LiDAR patch: best candidate by 2D score, then 3D. Fills the scores of
/// `match`, its outcome (kPose when a pose was found) and its pose.
void register_patch(std::size_t patch,
                    std::span<const PatchCandidate> candidates,
                    const PatchedCloud& lidar,
                    const PatchedCloud& vision,
                    const BoundaryTargets& targets,
                    const PaperOptions& options,
                    const NdtOptions& ndt,
                    PatchMatch& match);

}  // namespace hybridfusion
