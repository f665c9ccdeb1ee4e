#include "live_tracks.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hybridfusion {
namespace {

bool shows(const Track& track, std::uint32_t view) {
  return std::ranges::binary_search(track, view, {}, &TrackElement::view);
}

bool share_a_view(const Track& a, const Track& b) {
  return std::ranges::any_of(a, [&](const TrackElement& e) { return shows(b, e.view); });
}

}  // namespace

void LiveTracks::add_view(const FeatureSet& features) {
  // SIFT repeats a keypoint with another orientation at the same pixel: those are one feature.
  std::vector<std::uint32_t> order(features.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    return std::pair(features.pixels[i].x(), features.pixels[i].y());
  };
  std::ranges::stable_sort(order, {}, key);
  std::vector<std::uint32_t> same(features.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool repeated = k > 0 && key(order[k]) == key(order[k - 1]);
    same[order[k]] = repeated ? same[order[k - 1]] : order[k];
  }
  same_.push_back(std::move(same));
  track_of_.emplace_back(features.size(), kNone);
}

void LiveTracks::insert(const Node& node,
                        std::span<const FeatureSet> features,
                        std::uint32_t track,
                        SfmModel& model) {
  Track& elements = model.tracks[track];
  const auto at = std::ranges::lower_bound(elements, node.view, {}, &TrackElement::view);
  elements.insert(at,
                  {.view = node.view,
                   .feature = node.feature,
                   .pixel = features[node.view].pixels[node.feature].cast<double>()});
  track_of(node) = track;
}

void LiveTracks::merge(std::uint32_t into, std::uint32_t from, SfmModel& model) {
  for (TrackElement element : model.tracks[from]) {
    element.active = false;  // judged against the other track's point next time
    track_of({element.view, element.feature}) = into;
    Track& elements = model.tracks[into];
    elements.insert(std::ranges::lower_bound(elements, element.view, {}, &TrackElement::view),
                    element);
  }
  model.tracks[from].clear();
  model.points[from].reset();
}

void LiveTracks::add_pair(std::span<const FeatureSet> features,
                          const VerifiedPair& pair,
                          SfmModel& model) {
  for (const Match& match : pair.matches) {
    const Node a{pair.views.first, same_[pair.views.first][match.first]};
    const Node b{pair.views.second, same_[pair.views.second][match.second]};
    const std::uint32_t track_a = track_of(a);
    const std::uint32_t track_b = track_of(b);
    if (track_a == kNone && track_b == kNone) {
      const auto track = static_cast<std::uint32_t>(model.tracks.size());
      model.tracks.emplace_back();
      model.points.emplace_back();
      insert(a, features, track, model);
      insert(b, features, track, model);
    } else if (track_b == kNone) {
      if (!shows(model.tracks[track_a], b.view)) insert(b, features, track_a, model);
    } else if (track_a == kNone) {
      if (!shows(model.tracks[track_b], a.view)) insert(a, features, track_b, model);
    } else if (track_a != track_b && !share_a_view(model.tracks[track_a], model.tracks[track_b])) {
      // What has a point keeps it; of two, the longer.
      const auto rank = [&](std::uint32_t t) {
        return std::tuple(model.points[t].has_value(), model.tracks[t].size());
      };
      const bool keep_a = rank(track_a) >= rank(track_b);
      merge(keep_a ? track_a : track_b, keep_a ? track_b : track_a, model);
    }
  }
}

}  // namespace hybridfusion
