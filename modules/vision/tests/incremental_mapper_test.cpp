#include "incremental_mapper.hpp"

#include "enu_alignment.hpp"
#include "synthetic_flight.hpp"
#include "synthetic_matches.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct MappingCase {
  testing::SyntheticFlight flight;
  std::vector<VerifiedPair> pairs;
  GnssIngest gnss;
  SfmModel model;
  ReconstructionOptions options;

  explicit MappingCase(const testing::FlightOptions& flight_options)
      : flight(testing::make_flight(flight_options)), pairs(testing::verified_pairs(flight.truth)) {
    model = flight.truth;
    model.cameras[0] = model.priors[0].intrinsics;
    for (auto& pose : model.world_from_view) pose.reset();
    for (auto& point : model.points) point.reset();
    for (auto& track : model.tracks) {
      for (auto& element : track) element.active = false;
    }
    gnss.fixes.resize(model.world_from_view.size());
    for (std::size_t v = 0; v < gnss.fixes.size(); ++v) {
      gnss.fixes[v].position_in_enu = flight.truth.world_from_view[v]->translation;
      gnss.fixes[v].sigma_m = Eigen::Vector3d::Constant(3.0);
      gnss.fixes[v].has_altitude = true;
    }
  }

  [[nodiscard]] double rms_after_similarity_m() const {
    std::vector<Eigen::Vector3d> target;
    std::vector<Eigen::Vector3d> source;
    for (const std::uint32_t v : model.registered()) {
      target.push_back(flight.truth.world_from_view[v]->translation);
      source.push_back(model.world_from_view[v]->translation);
    }
    const Sim3 sim = fit_sim3(target, source).value();
    double sum2 = 0.0;
    for (std::size_t i = 0; i < target.size(); ++i)
      sum2 += (sim * source[i] - target[i]).squaredNorm();
    return std::sqrt(sum2 / static_cast<double>(target.size()));
  }
};

TEST(IncrementalMapper, RegistersAWholeFlightWithUnknownDistortion) {
  MappingCase run({.num_points = 600});
  IncrementalMapper mapper(run.model, run.pairs, run.gnss, run.options, {});
  ASSERT_TRUE(mapper.grow(std::vector<bool>(run.model.world_from_view.size(), true)));
  EXPECT_EQ(run.model.num_registered(), run.model.world_from_view.size());
  // 12 views, 0.3 px, calibration estimated on the way.
  EXPECT_LT(run.rms_after_similarity_m(), 0.10);
}

TEST(IncrementalMapper, ViewWithoutPointsStaysOutWithAReason) {
  MappingCase run({.columns = 3, .num_points = 500});
  for (auto& track : run.model.tracks) {
    std::erase_if(track, [](const TrackElement& e) { return e.view == 5; });
  }
  index_tracks(run.model);
  std::erase_if(run.pairs,
                [](const VerifiedPair& p) { return p.views.first == 5 || p.views.second == 5; });
  IncrementalMapper mapper(run.model, run.pairs, run.gnss, run.options, {});
  ASSERT_TRUE(mapper.grow(std::vector<bool>(run.model.world_from_view.size(), true)));
  EXPECT_EQ(run.model.num_registered(), run.model.world_from_view.size() - 1);
  EXPECT_FALSE(run.model.world_from_view[5]);
  EXPECT_FALSE(mapper.reasons()[5].empty());
}

TEST(IncrementalMapper, NumberOfThreadsDoesNotChangeABit) {
  std::vector<Eigen::Vector3d> centres[2];
  for (const int threads : {1, 3}) {
    MappingCase run({.columns = 3, .rows = 2, .num_points = 400});
    RunContext ctx;
    ctx.num_threads = threads;
    IncrementalMapper mapper(run.model, run.pairs, run.gnss, run.options, ctx);
    ASSERT_TRUE(mapper.grow(std::vector<bool>(run.model.world_from_view.size(), true)));
    for (const auto& pose : run.model.world_from_view) {
      centres[threads == 1 ? 0 : 1].push_back(pose ? pose->translation : Eigen::Vector3d::Zero());
    }
  }
  EXPECT_EQ(centres[0], centres[1]);
}

TEST(SelectTracks, KeepsLongTracksAndEveryPartOfEveryView) {
  const auto flight = testing::make_flight({.num_points = 900});
  const auto some = select_tracks(flight.truth, 64);
  const auto all = select_tracks(flight.truth, 0);
  EXPECT_LT(some.size(), all.size());
  EXPECT_GT(some.size(), 64U);
}

}  // namespace
}  // namespace hybridfusion
