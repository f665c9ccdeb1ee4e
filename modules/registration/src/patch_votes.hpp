#pragma once

#include "fine_samples.hpp"
#include "prepared_clouds.hpp"

#include <vector>

namespace hybridfusion {

/// What the patches of L say about a pose.
struct PatchVotes {
  std::vector<PatchMatch> patches = {};  ///< Poses in the leveled frame.
  std::size_t num_tried = 0;             ///< With boundary enough in both clouds.
  std::size_t num_poses = 0;             ///< Of these, inside the window.
  std::size_t num_members = 0;           ///< Of these, in the cluster around the pose.
  double spread_m = 0.0;                 ///< Root mean square of the members' horizontal moves.

  [[nodiscard]] double share() const {
    return num_tried == 0 ? 0.0 : static_cast<double>(num_members) / static_cast<double>(num_tried);
  }
};

/// Cuts L into patches (HybridFusion III-C.1), registers each to G from `vision_from_leveled`: the
/// boundaries of the patch and its neighbours by 2D NDT (III-C.4), the planes of the patch point to
/// plane; and clusters how far they moved (III-C.5). Moves are taken at the patch, where a small
/// turn is no long way. No patch has a vote where nothing stands on the ground.
/// @returns kCancelled when stopped.
[[nodiscard]] Expected<PatchVotes> vote_by_patches(FineInputs& inputs,
                                                   const PreparedClouds& clouds,
                                                   const Rigid3& vision_from_leveled,
                                                   const FineOptions& fine,
                                                   const PatchVoteOptions& options,
                                                   const RunContext& ctx);

}  // namespace hybridfusion
