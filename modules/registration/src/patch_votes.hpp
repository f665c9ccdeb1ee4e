#pragma once

#include "fine_samples.hpp"
#include "prepared_clouds.hpp"

#include <vector>

namespace hybridfusion {

/// What the patches of L say about a pose.
struct PatchVotes {
  std::vector<PatchMatch> patches = {};  ///< Poses in the leveled frame.
  std::size_t num_tried = 0;             ///< With facades enough, over known parts of G.
  std::size_t num_poses = 0;             ///< Of these, inside the window.
  std::size_t num_members = 0;           ///< Of these, in the cluster around the pose.
  double spread_m = 0.0;                 ///< Root mean square of the members' horizontal moves.

  [[nodiscard]] double share() const {
    return num_tried == 0 ? 0.0 : static_cast<double>(num_members) / static_cast<double>(num_tried);
  }
};

/// Cuts L into patches (HybridFusion III-C.1), registers each to G around `vision_from_leveled`,
/// and clusters how far they moved (III-C.5). In place of the 2D NDT of boundaries (III-C.4), the
/// facades of a patch and its neighbours look for roof rims in the whole window: where G holds few
/// facade points, its boundary is a rim and that of L a wall, and NDT slides along them. Then the
/// planes of the patch, point to plane. Moves are taken at the patch, where a small turn is no long
/// way. No patch has a vote where nothing stands on the ground.
/// @param overhang_m  Of roofs over facades, as found with the pose.
/// @returns kCancelled when stopped.
[[nodiscard]] Expected<PatchVotes> vote_by_patches(FineInputs& inputs,
                                                   const PreparedClouds& clouds,
                                                   const Rigid3& vision_from_leveled,
                                                   double overhang_m,
                                                   const RegistrationOptions& options,
                                                   const RunContext& ctx);

}  // namespace hybridfusion
