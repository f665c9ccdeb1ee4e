#include "live/live_tracks.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

FeatureSet grid_features(std::size_t count) {
  FeatureSet features;
  for (std::size_t i = 0; i < count; ++i) {
    features.pixels.emplace_back(static_cast<float>(i), 1.0F);
  }
  return features;
}

/// Tracks as sets of (view, feature), without order.
std::set<std::vector<std::pair<std::uint32_t, std::uint32_t>>> as_sets(
    const std::vector<Track>& tracks) {
  std::set<std::vector<std::pair<std::uint32_t, std::uint32_t>>> sets;
  for (const Track& track : tracks) {
    if (track.empty()) continue;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> elements;
    for (const TrackElement& e : track) elements.emplace_back(e.view, e.feature);
    sets.insert(elements);
  }
  return sets;
}

TEST(LiveTracks, WithoutContradictionsTheyAreThoseOfAllPairsAtOnce) {
  constexpr std::uint32_t kViews = 7;
  constexpr std::uint32_t kFeatures = 60;
  std::vector<FeatureSet> features(kViews, grid_features(kFeatures));
  Random random(5, "test/tracks");
  std::vector<VerifiedPair> pairs;
  // Feature i of every view shows point i: any subset of true matches is free of contradictions.
  for (std::uint32_t b = 1; b < kViews; ++b) {
    for (std::uint32_t a = 0; a < b; ++a) {
      VerifiedPair pair{.views = {a, b}};
      for (std::uint32_t i = 0; i < kFeatures; ++i) {
        if (random.uniform() < 0.35) pair.matches.push_back({i, i});
      }
      pairs.push_back(pair);
    }
  }
  LiveTracks live;
  SfmModel model;
  for (std::uint32_t view = 0; view < kViews; ++view) {
    live.add_view(features[view]);
    for (const VerifiedPair& pair : pairs) {
      if (pair.views.second == view) live.add_pair(features, pair, model);
    }
  }
  EXPECT_EQ(as_sets(model.tracks), as_sets(build_tracks(features, pairs)));
  for (const Track& track : model.tracks) {
    EXPECT_TRUE(std::ranges::is_sorted(track, {}, &TrackElement::view));
  }
  EXPECT_EQ(model.points.size(), model.tracks.size());
}

TEST(LiveTracks, AMatchThatShowsAPointTwiceInOnePhotoIsRefused) {
  const std::vector<FeatureSet> features(3, grid_features(4));
  LiveTracks live;
  SfmModel model;
  for (const FeatureSet& f : features) live.add_view(f);
  live.add_pair(features, {.views = {0, 1}, .matches = {{0, 0}, {1, 1}}}, model);
  live.add_pair(features, {.views = {0, 2}, .matches = {{0, 3}}}, model);
  live.add_pair(features, {.views = {1, 2}, .matches = {{1, 3}}}, model);  // would join both
  using Elements = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  EXPECT_EQ(as_sets(model.tracks),
            (std::set<Elements>{{{0, 0}, {1, 0}, {2, 3}}, {{0, 1}, {1, 1}}}));
}

TEST(LiveTracks, RepeatedKeypointsOfOnePixelAreOne) {
  std::vector<FeatureSet> features(2, grid_features(2));
  features[1].pixels[1] = features[1].pixels[0];
  LiveTracks live;
  SfmModel model;
  for (const FeatureSet& f : features) live.add_view(f);
  live.add_pair(features, {.views = {0, 1}, .matches = {{0, 1}}}, model);
  live.add_pair(features, {.views = {0, 1}, .matches = {{0, 0}}}, model);
  ASSERT_EQ(model.tracks.size(), 1U);
  EXPECT_EQ(model.tracks[0].size(), 2U);
}

TEST(LiveTracks, AJoinedTrackKeepsThePointItHas) {
  const std::vector<FeatureSet> features(4, grid_features(3));
  LiveTracks live;
  SfmModel model;
  for (const FeatureSet& f : features) live.add_view(f);
  live.add_pair(features, {.views = {0, 1}, .matches = {{0, 0}}}, model);
  live.add_pair(features, {.views = {2, 3}, .matches = {{0, 0}}}, model);
  model.points[1] = Eigen::Vector3d(1, 2, 3);
  live.add_pair(features, {.views = {1, 2}, .matches = {{0, 0}}}, model);
  EXPECT_TRUE(model.tracks[0].empty());
  EXPECT_FALSE(model.points[0]);
  EXPECT_EQ(model.tracks[1].size(), 4U);
  EXPECT_EQ(model.points[1], Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace hybridfusion
