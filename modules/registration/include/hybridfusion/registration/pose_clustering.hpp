#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

struct PoseCluster {
  std::vector<std::size_t> members = {};  ///< Indices into the input poses, ascending.
  Rigid3 mean = {};  ///< Mean of translations, sequential slerp mean of rotations.
};

/// Groups poses that are pairwise closer than `radius_m` (epsilon) and `angle_rad` (omega) and
/// returns the largest group (HybridFusion III-C.5). Deterministic: ties go to the group found from
/// the smallest seed index. Translations depend on the frame's origin: give poses in a frame
/// centred on the LiDAR cloud, else a small rotation looks like a long way.
/// @returns kInsufficient when `poses` is empty, kDegenerate when none is finite. @pre radius_m >
/// 0, angle_rad > 0
[[nodiscard]] Expected<PoseCluster> largest_pose_cluster(std::span<const Rigid3> poses,
                                                         double radius_m,
                                                         double angle_rad);

}  // namespace hybridfusion
