#pragma once

#include "sfm_model.hpp"
#include "tracks.hpp"

#include <map>
#include <utility>
#include <vector>

namespace hybridfusion::testing {

/// What verification would hand over: pairs with many common points.
inline std::vector<VerifiedPair> verified_pairs(const SfmModel& truth) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Match>> common;
  for (const Track& track : truth.tracks) {
    for (std::size_t i = 0; i < track.size(); ++i) {
      for (std::size_t j = i + 1; j < track.size(); ++j) {
        common[{track[i].view, track[j].view}].push_back({track[i].feature, track[j].feature});
      }
    }
  }
  std::vector<VerifiedPair> pairs;
  for (const auto& [views, matches] : common) {
    if (matches.size() < 60) continue;
    Rigid3 second_from_first =
        truth.world_from_view[views.second]->inverse() * *truth.world_from_view[views.first];
    const double base_m = second_from_first.translation.norm();
    second_from_first.translation.normalize();
    pairs.push_back({.views = {views.first, views.second},
                     .matches = matches,
                     .second_from_first = second_from_first,
                     .median_angle_rad = base_m / 60.0,
                     .homography_share = 0.6});
  }
  return pairs;
}

}  // namespace hybridfusion::testing
