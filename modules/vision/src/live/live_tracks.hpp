#pragma once

#include "features.hpp"
#include "sfm_model.hpp"
#include "tracks.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace hybridfusion {

/// Tracks that grow with each pair: what build_tracks finds in all pairs at once, but for
/// contradictions. A match that would show a point twice in one photo is refused here, where
/// build_tracks drops the whole component.
class LiveTracks {
 public:
  /// Announces the next view, empty ones too.
  void add_view(const FeatureSet& features);
  /// Takes the matches of a pair into the model's tracks; a track that joined another is left
  /// empty, without a point. `tracks_of_view` is out of date afterwards: see index_tracks().
  void add_pair(std::span<const FeatureSet> features, const VerifiedPair& pair, SfmModel& model);

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  struct Node {
    std::uint32_t view = 0;
    std::uint32_t feature = 0;
  };
  [[nodiscard]] std::uint32_t& track_of(const Node& node) {
    return track_of_[node.view][node.feature];
  }
  void insert(const Node& node,
              std::span<const FeatureSet> features,
              std::uint32_t track,
              SfmModel& model);
  void merge(std::uint32_t into, std::uint32_t from, SfmModel& model);

  std::vector<std::vector<std::uint32_t>> same_;  // per view and feature: the first at its pixel
  std::vector<std::vector<std::uint32_t>> track_of_;  // per view and feature
};

}  // namespace hybridfusion
