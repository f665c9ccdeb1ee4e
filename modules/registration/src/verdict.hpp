#pragma once

#include "fine_alignment.hpp"
#include "hybrid.hpp"

#include <string>

namespace hybridfusion {

/// Everything measured about the best place.
struct Evidence {
  double best_score = 0.0;
  double second_score = 0.0;
  Eigen::Vector2d second_offset = Eigen::Vector2d::Zero();  ///< From the best place [m].
  double second_turn_rad = 0.0;                             ///< From the best place's heading.
  PoseEvidence best = {};                                   ///< At the final pose.
  std::size_t ground_inliers = 0;
  double linear_share = 0.0;
  RidgeTest ridge = {};
  bool used_prior = false;
  bool has_fine = false;     ///< The surfaces could be aligned,
  bool fine_agrees = false;  ///< ... and stayed where the outlines were,
  bool fine_stays = false;   ///< ... or at least at their peak.
  FineResult fine = {};
  bool surfaces_compared = false;  ///< The places alike in outline were compared by surfaces.
  double facade_support = 0.0;     ///< Of the best place; 0 where it was not asked for.
  double rival_support = 0.0;      ///< Largest of the others.
  std::size_t patches_tried = 0;
  double patch_share = 0.0;  ///< Of these, in the cluster around the pose.
  double patch_spread_m = 0.0;
};

struct SurfaceVerdict {
  double confidence = 0.0;
  std::string reason =
      {};  ///< To refuse the pose; empty when its surfaces do not speak against it.
};

/// What facades and ground alone say of a pose, however it was found: rims under the facades, no
/// facades on open ground, one ground, and none of it inside buildings.
[[nodiscard]] SurfaceVerdict judge_surfaces(const PoseEvidence& evidence,
                                            const VerdictOptions& options);

/// Status, reason, confidence and scores of `result` from the evidence.
void pronounce(const Evidence& evidence, const VerdictOptions& options, RegistrationResult& result);

}  // namespace hybridfusion
