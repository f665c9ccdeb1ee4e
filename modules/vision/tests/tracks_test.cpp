#include "tracks.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

FeatureSet features_at(std::vector<Eigen::Vector2f> pixels) {
  FeatureSet features;
  features.pixels = std::move(pixels);
  return features;
}

VerifiedPair pair_of(std::uint32_t a, std::uint32_t b, std::vector<Match> matches) {
  return {.views = {a, b}, .matches = std::move(matches)};
}

std::vector<FeatureSet> three_views() {
  return {features_at({{1, 1}, {2, 2}, {3, 3}}),
          features_at({{11, 1}, {12, 2}, {13, 3}}),
          features_at({{21, 1}, {22, 2}, {23, 3}})};
}

TEST(BuildTracks, MatchesChainIntoOneTrack) {
  const auto features = three_views();
  const std::vector<VerifiedPair> pairs{pair_of(0, 1, {{0, 2}}), pair_of(1, 2, {{2, 1}})};
  const auto tracks = build_tracks(features, pairs);
  ASSERT_EQ(tracks.size(), 1U);
  ASSERT_EQ(tracks[0].size(), 3U);
  EXPECT_EQ(tracks[0][1].feature, 2U);
  EXPECT_EQ(tracks[0][2].pixel, Eigen::Vector2d(22, 2));
}

TEST(BuildTracks, TrackWithTwoPlacesInOneViewIsDropped) {
  const auto features = three_views();
  // 0:0 - 1:0 - 2:0 and 2:0 - 1:1: view 1 would show the point twice.
  const std::vector<VerifiedPair> pairs{pair_of(0, 1, {{0, 0}, {2, 2}}),
                                        pair_of(1, 2, {{0, 0}, {1, 0}})};
  const auto tracks = build_tracks(features, pairs);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0][0].feature, 2U);
}

TEST(BuildTracks, KeypointRepeatedAtOnePixelIsNoContradiction) {
  auto features = three_views();
  features[1].pixels[1] = features[1].pixels[0];
  const std::vector<VerifiedPair> pairs{pair_of(0, 1, {{0, 0}}), pair_of(1, 2, {{1, 0}})};
  const auto tracks = build_tracks(features, pairs);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].size(), 3U);
}

TEST(BuildTracks, OrderOfThePairsDoesNotMatter) {
  const auto features = three_views();
  std::vector<VerifiedPair> pairs{
      pair_of(0, 1, {{0, 2}, {1, 1}}), pair_of(1, 2, {{2, 1}, {1, 0}}), pair_of(0, 2, {{2, 2}})};
  const auto forward = build_tracks(features, pairs);
  std::ranges::reverse(pairs);
  const auto backward = build_tracks(features, pairs);
  ASSERT_EQ(forward.size(), backward.size());
  for (std::size_t t = 0; t < forward.size(); ++t) {
    ASSERT_EQ(forward[t].size(), backward[t].size());
    EXPECT_EQ(forward[t][0].feature, backward[t][0].feature);
  }
}

}  // namespace
}  // namespace hybridfusion
