#pragma once

#include "features.hpp"
#include "matching.hpp"
#include "pair_selection.hpp"
#include "sfm_model.hpp"

#include <span>
#include <vector>

namespace hybridfusion {

/// Matches of a pair that agree with one relative pose.
struct VerifiedPair {
  PhotoPair views = {};
  std::vector<Match> matches = {};
  Rigid3 second_from_first = {};  ///< Unit translation.
  double median_angle_rad = 0.0;  ///< Between the two rays of a match.
  double homography_share = 0.0;  ///< Share of the matches on one plane (or without parallax).
};

/// Connected components of the matches over all pairs (union-find). Keypoints of one photo at the
/// same pixel count as one. A component with two keypoints of one photo contradicts itself and is
/// dropped. Ascending by first view and feature: independent of the order of the pairs.
[[nodiscard]] std::vector<Track> build_tracks(std::span<const FeatureSet> features,
                                              std::span<const VerifiedPair> pairs);

}  // namespace hybridfusion
