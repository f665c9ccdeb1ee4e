#include "fragments.hpp"

#include "gnss_adjustment.hpp"
#include "second_round.hpp"
#include "synthetic_flight.hpp"
#include "synthetic_matches.hpp"

#include <algorithm>
#include <iterator>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Case {
  SfmModel truth;
  SfmModel empty;
  std::vector<VerifiedPair> pairs;
  GnssIngest gnss;
  std::vector<PhotoMetadata> photos;
};

/// A flight whose connecting photos are missing: no track joins the four columns on the left and
/// those on the right. GNSS is good to `sigma_m`.
Case make_case(double sigma_m) {
  Case c;
  c.truth = testing::make_flight({.columns = 8, .rows = 3, .num_points = 900}).truth;
  // Strips run forth and back.
  const auto is_left = [](const TrackElement& e) {
    return (e.view / 8) % 2 == 0 ? e.view % 8 < 4 : e.view % 8 >= 4;
  };
  std::vector<Track> tracks;
  std::vector<std::optional<Eigen::Vector3d>> points;
  for (std::size_t t = 0; t < c.truth.tracks.size(); ++t) {
    for (const bool left : {true, false}) {
      Track half;
      std::ranges::copy_if(c.truth.tracks[t], std::back_inserter(half), [&](const auto& e) {
        return is_left(e) == left;
      });
      if (half.size() < 2) continue;
      tracks.push_back(std::move(half));
      points.push_back(c.truth.points[t]);
    }
  }
  c.truth.tracks = std::move(tracks);
  c.truth.points = std::move(points);
  index_tracks(c.truth);
  c.pairs = testing::verified_pairs(c.truth);
  c.empty = c.truth;
  c.empty.cameras[0] = c.empty.priors[0].intrinsics;
  for (auto& pose : c.empty.world_from_view) pose.reset();
  for (auto& point : c.empty.points) point.reset();
  for (Track& track : c.empty.tracks) {
    for (TrackElement& element : track) element.active = false;
  }
  Random random(4, "test/fragments");
  for (std::size_t v = 0; v < c.truth.world_from_view.size(); ++v) {
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    c.gnss.fixes.push_back(
        {.position_in_enu = c.truth.world_from_view[v]->translation + sigma_m * noise,
         .sigma_m = Eigen::Vector3d::Constant(sigma_m),
         .has_altitude = true,
         .flight_time_s = 2.5 * static_cast<double>(v)});
    c.gnss.by_time.push_back(v);
    c.photos.emplace_back().name = "P" + std::to_string(v);
  }
  return c;
}

TEST(Fragments, ShareTheMapThoughNoPhotoLinksThem) {
  const Case c = make_case(0.05);
  const ReconstructionOptions options;
  auto mapped = map_fragments(c.empty, c.pairs, c.gnss, c.photos, options, {});
  ASSERT_TRUE(mapped) << mapped.error().message;
  EXPECT_EQ(mapped->model.num_registered(), c.truth.world_from_view.size());
  EXPECT_TRUE(std::ranges::any_of(mapped->warnings, [](const std::string& warning) {
    return warning.find("placed by GNSS only") != std::string::npos;
  }));
  GnssTerms terms = gnss_terms(mapped->model, c.gnss, options.gnss, mapped->placement);
  ASSERT_TRUE(adjust_with_gnss(mapped->model, terms, {}, options, {}));
  for (const std::uint32_t view : mapped->model.registered()) {
    EXPECT_LT((mapped->model.world_from_view[view]->translation -
               c.truth.world_from_view[view]->translation)
                  .norm(),
              0.25);
  }
}

TEST(SecondRound, SuggestsPairsAcrossTheGapAndForPhotosLeftOut) {
  Case c = make_case(0.05);
  c.truth.world_from_view[0].reset();
  const auto pairs = second_round_pairs(c.truth, c.pairs, c.gnss, {});
  const auto column = [](std::uint32_t view) {
    return (view / 8) % 2 == 0 ? view % 8 : 7 - view % 8;
  };
  // Strip 2 runs back: views 11 and 12 are its columns 4 and 3, on either side of the gap.
  EXPECT_TRUE(std::ranges::binary_search(pairs, PhotoPair{.first = 11, .second = 12}));
  for (const PhotoPair& pair : pairs) {
    if (pair.first == 0) continue;
    EXPECT_NE(column(pair.first) < 4, column(pair.second) < 4);
  }
  EXPECT_TRUE(std::ranges::any_of(pairs, [](const PhotoPair& pair) { return pair.first == 0; }));
}

TEST(Fragments, WithoutPositionsOnlyTheFirstOneStaysAndTheOthersSayWhy) {
  Case c = make_case(0.05);
  for (PhotoFix& fix : c.gnss.fixes) fix.position_in_enu.reset();
  const auto mapped = map_fragments(c.empty, c.pairs, c.gnss, c.photos, {}, {});
  ASSERT_TRUE(mapped) << mapped.error().message;
  EXPECT_EQ(mapped->model.num_registered(), 12U);
  for (std::size_t v = 0; v < c.photos.size(); ++v) {
    EXPECT_NE(mapped->model.world_from_view[v].has_value(), !mapped->reasons[v].empty()) << v;
  }
}

}  // namespace
}  // namespace hybridfusion
