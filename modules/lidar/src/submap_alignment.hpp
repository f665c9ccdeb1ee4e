#pragma once

#include "submap.hpp"

#include <hybridfusion/core/rigid3.hpp>

#include <optional>

namespace hybridfusion {

struct SubmapAlignment {
  Rigid3 target_from_source = {};
  std::size_t num_inliers = 0;
  double overlap = 0.0;       ///< Share of the source's faces with a face of the target nearby.
  double inlier_share = 0.0;  ///< Of those, the share that lies on it.
  double rms_m = 0.0;         ///< Of the inliers' distances.
  /// Smallest mean squared cosine between the inliers' normals and a direction, turns left free:
  /// near zero where the source can slide.
  double min_cosine2 = 0.0;
};

/// Height [m] that brings the source's ground onto the target's: the median over plan cells that
/// both saw, with the source placed by `target_from_source`; nothing when they share too few.
[[nodiscard]] std::optional<double> ground_offset(const Submap& target,
                                                  const Submap& source,
                                                  const Rigid3& target_from_source);

/// Point-to-plane alignment of faces from a guess that is good to about a metre and three degrees.
/// Directions that no face holds stay as guessed. Nothing when too few faces meet.
[[nodiscard]] std::optional<SubmapAlignment> align_submaps(const Submap& target,
                                                           const Submap& source,
                                                           const Rigid3& guess);

}  // namespace hybridfusion
