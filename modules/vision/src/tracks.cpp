#include "tracks.hpp"

#include <algorithm>
#include <numeric>

namespace hybridfusion {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::size_t find(std::size_t node) {
    while (parent_[node] != node) {
      parent_[node] = parent_[parent_[node]];
      node = parent_[node];
    }
    return node;
  }
  /// The smaller root wins, so that the result does not depend on the order of the unions.
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// SIFT repeats a keypoint with another orientation at the same pixel: those are one feature.
void unite_repeated(UnionFind& nodes, const FeatureSet& features, std::size_t offset) {
  std::vector<std::size_t> order(features.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t i) {
    return std::pair(features.pixels[i].x(), features.pixels[i].y());
  };
  std::ranges::stable_sort(order, {}, key);
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (key(order[k]) == key(order[k - 1])) nodes.unite(offset + order[k], offset + order[k - 1]);
  }
}

/// Merges elements at one pixel; false when a view shows the track at two places.
bool make_consistent(Track& track) {
  std::ranges::sort(track, {}, [](const TrackElement& e) { return std::pair(e.view, e.feature); });
  Track merged;
  for (const TrackElement& element : track) {
    if (!merged.empty() && merged.back().view == element.view) {
      if (merged.back().pixel != element.pixel) return false;
    } else {
      merged.push_back(element);
    }
  }
  track = std::move(merged);
  return track.size() >= 2;
}

}  // namespace

std::vector<Track> build_tracks(std::span<const FeatureSet> features,
                                std::span<const VerifiedPair> pairs) {
  std::vector<std::size_t> offset(features.size() + 1, 0);
  for (std::size_t v = 0; v < features.size(); ++v) offset[v + 1] = offset[v] + features[v].size();
  UnionFind nodes(offset.back());
  std::vector<bool> matched(offset.back(), false);
  for (std::size_t v = 0; v < features.size(); ++v) unite_repeated(nodes, features[v], offset[v]);
  for (const VerifiedPair& pair : pairs) {
    for (const Match& match : pair.matches) {
      const std::size_t a = offset[pair.views.first] + match.first;
      const std::size_t b = offset[pair.views.second] + match.second;
      nodes.unite(a, b);
      matched[a] = true;
      matched[b] = true;
    }
  }
  std::vector<Track> by_root(offset.back());
  for (std::uint32_t v = 0; v < features.size(); ++v) {
    for (std::uint32_t f = 0; f < features[v].size(); ++f) {
      if (!matched[offset[v] + f]) continue;
      by_root[nodes.find(offset[v] + f)].push_back(
          {.view = v, .feature = f, .pixel = features[v].pixels[f].cast<double>()});
    }
  }
  std::vector<Track> tracks;
  for (Track& track : by_root) {
    if (track.size() >= 2 && make_consistent(track)) tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace hybridfusion
