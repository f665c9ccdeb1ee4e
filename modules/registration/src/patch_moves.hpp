#pragma once

#include "fine_samples.hpp"
#include "outline_search.hpp"

#include <optional>
#include <vector>

namespace hybridfusion {

/// A patch of L with its move: point_after = move (point - centre) + centre, in vision.
struct VotingPatch {
  std::size_t match = 0;  ///< Into PatchVotes::patches.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Rigid3 move = {};
  std::vector<std::size_t> samples = {};  ///< Into FineInputs::samples.
};

/// What of `pattern`, brought to vision by `pose`, lies within `half_side_m` of `centre` in x and
/// y; relative to `centre`.
[[nodiscard]] PlanarPattern pattern_around(const PlanarPattern& pattern,
                                           const PlanarPose& pose,
                                           const Eigen::Vector2d& centre,
                                           double half_side_m);

/// The best place of `patch` (relative to `centre`) among all within the window of `votes`, not
/// the nearest local one: a patch that lies there by chance has a better place elsewhere. Among
/// equals it stays where it is.
/// @returns nothing when no place in the window brings a facade onto a rim.
[[nodiscard]] std::optional<PlanarPose> best_place_nearby(const VisionMaps& vision,
                                                          const PlanarPattern& patch,
                                                          const Eigen::Vector2d& centre,
                                                          double overhang_m,
                                                          const OutlineOptions& outline,
                                                          const PatchVoteOptions& votes);

/// Point-to-plane refinement of every patch by shift and heading, held softly where its planes
/// leave a direction free.
/// @param pose  Vision from the frame of the samples.
void align_planes(FineInputs& inputs,
                  const Rigid3& pose,
                  const FineOptions& fine,
                  std::vector<VotingPatch>& patches,
                  const RunContext& ctx);

}  // namespace hybridfusion
