#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/paper_options.hpp>
#include <hybridfusion/registration/patch_match.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// A thinned, finite cloud and how high each point stands above the cloud's own ground [m].
struct GroundedCloud {
  std::span<const Eigen::Vector3f> points = {};
  std::span<const float> heights = {};
};

/// Outcome of the published chain. A pose that is not `supported` is the best there was, never an
/// answer.
struct PaperResult {
  bool supported = false;         ///< The largest cluster has enough members and a clear majority.
  std::string reason = {};        ///< Why it is not supported, or what was left out.
  Rigid3 vision_from_lidar = {};  ///< The coarse pose when no patch gave one.
  bool adjusted = false;          ///< The final 3D NDT stayed with the cluster and was taken.
  std::size_t num_poses = 0;      ///< |K|.
  std::size_t num_cluster_members = 0;
  std::size_t num_runner_up = 0;  ///< Members of the largest cluster elsewhere.
  double cluster_spread_m = 0.0;  ///< Largest distance of a member from the mean, at the centroid.
  std::vector<PatchMatch> patches = {};  ///< Every LiDAR patch with at least eta points.
};

/// HybridFusion III-C with Algorithm 1: patches, candidate ring, ESF descriptors, neighbour filter,
/// 2D NDT of boundaries, 3D NDT, pose clustering, final 3D NDT. It has no other prior than the
/// coarse pose: heading and position must be about right.
/// @param vision  In the vision frame.
/// @param lidar   In the LiDAR frame, whose origin is GNSS_origin of the candidate ring.
/// @param ndt     Of the 3D NDT.
/// @returns kInsufficient for an empty cloud, kInvalidOptions for a patch step far too small,
///          kCancelled when stopped. @pre heights are as many as points
[[nodiscard]] Expected<PaperResult> register_by_patches(const GroundedCloud& vision,
                                                        const GroundedCloud& lidar,
                                                        const Rigid3& vision_from_lidar_coarse,
                                                        const PaperOptions& options = {},
                                                        const NdtOptions& ndt = {},
                                                        const RunContext& ctx = {});

}  // namespace hybridfusion
