#include <hybridfusion/registration/neighbour_filter.hpp>
#include <hybridfusion/registration/patch_candidates.hpp>

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// A 100 x 100 m plain around the origin, one point a metre, in 10 m patches.
struct Plain {
  std::vector<Eigen::Vector3f> points = [] {
    std::vector<Eigen::Vector3f> p;
    for (int y = -50; y < 50; ++y) {
      for (int x = -50; x < 50; ++x)
        p.emplace_back(Eigen::Vector3d(x + 0.5, y + 0.5, 0.0).cast<float>());
    }
    return p;
  }();
  PatchGrid grid = *grid_into_patches(points, 10.0, 0.0);

  [[nodiscard]] std::vector<std::size_t> select(const Eigen::Vector2d& centroid,
                                                const Eigen::Vector2d& origin,
                                                double ratio,
                                                double bearing) const {
    return select_candidates(
        centroid, origin, grid, points, {.ring_ratio = ratio, .max_bearing_rad = bearing});
  }
};

/// A signature that is `a` times one pattern plus `b` times another, uncorrelated one.
CentredSignature mix(float a, float b) {
  EsfSignature s{};
  for (std::size_t i = 0; i < s.size(); ++i) {
    s[i] = a * (i % 2 == 0 ? 1.0F : -1.0F) + b * (i % 4 < 2 ? 1.0F : -1.0F);
  }
  return centre_signature(s);
}

TEST(SelectCandidates, EveryCandidateTouchesTheRingAndLiesInTheSector) {
  const Plain plain;
  const Eigen::Vector2d centroid(30.0, 0.0);
  const double bearing = std::numbers::pi / 6.0;
  const auto chosen = plain.select(centroid, {0.0, 0.0}, 0.2, bearing);
  ASSERT_FALSE(chosen.empty());
  for (std::size_t p = 0; p < plain.grid.patches.size(); ++p) {
    const Patch& patch = plain.grid.patches[p];
    bool touches = false;
    for (const auto i : patch.indices) {
      const float d = plain.points[i].head<2>().norm();
      touches = touches || (d >= 24.0F && d <= 36.0F);
    }
    const bool in_sector = std::abs(std::atan2(patch.centroid.y(), patch.centroid.x())) <= bearing;
    EXPECT_EQ(std::ranges::count(chosen, p), touches && in_sector ? 1 : 0);
  }
}

TEST(SelectCandidates, NearTheOriginEveryBearingIsAccepted) {
  const Plain plain;
  const auto chosen = plain.select({3.0, 2.0}, {0.0, 0.0}, 0.2, 0.1);
  bool left = false;
  bool right = false;
  for (const std::size_t p : chosen) {
    left = left || plain.grid.patches[p].centroid.x() < 0.0;
    right = right || plain.grid.patches[p].centroid.x() > 0.0;
  }
  EXPECT_TRUE(left && right);
  EXPECT_GE(chosen.size(), 4U);   // the four patches that meet at the origin at least
  EXPECT_LE(chosen.size(), 16U);  // within 1.2 steps of it
}

TEST(SelectCandidates, ARingOutsideTheCloudHasNoCandidates) {
  const Plain plain;
  EXPECT_TRUE(plain.select({500.0, 0.0}, {0.0, 0.0}, 0.2, 1.0).empty());
}

TEST(FilterByCorrelation, KeepsWhatIsAboveTheThresholdAndDescribed) {
  const PatchSignatures vision = {mix(1, 0), mix(1, 0.5F), mix(0, 1), std::nullopt};
  const std::vector<std::size_t> candidates = {0, 1, 2, 3};
  const auto kept = filter_by_correlation(mix(1, 0), candidates, vision, 0.6);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].vision_patch, 0U);
  EXPECT_NEAR(kept[0].correlation, 1.0, 1e-6);
  EXPECT_EQ(kept[1].vision_patch, 1U);
  EXPECT_NEAR(kept[1].correlation, 1.0 / std::sqrt(1.25), 1e-6);
}

TEST(BestByCorrelation, KeepsTheBestWhateverTheirCorrelation) {
  const PatchSignatures vision = {mix(0, 1), mix(1, 0.5F), std::nullopt, mix(1, 0), mix(-1, 0)};
  const std::vector<std::size_t> candidates = {0, 1, 2, 3, 4};
  const auto kept = best_by_correlation(mix(1, 0), candidates, vision, 3);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0].vision_patch, 3U);
  EXPECT_EQ(kept[1].vision_patch, 1U);
  EXPECT_EQ(kept[2].vision_patch, 0U);  // uncorrelated, yet third
  EXPECT_EQ(best_by_correlation(mix(1, 0), candidates, vision, 9).size(), 4U);
}

TEST(NeighbourSimilarity, TakesTheBestMatchOfEachNeighbourInAnyDirection) {
  const PatchSignatures lidar = {mix(1, 0), mix(0, 1), std::nullopt};
  const PatchSignatures vision = {mix(0, 1), mix(1, 0)};  // the other way round
  const std::vector<std::size_t> all_lidar = {0, 1, 2};
  const std::vector<std::size_t> both = {0, 1};
  const std::vector<std::size_t> second = {1};
  EXPECT_NEAR(neighbour_similarity(all_lidar, lidar, both, vision), 1.0, 1e-6);
  EXPECT_NEAR(neighbour_similarity(all_lidar, lidar, second, vision), 0.5, 1e-6);
  EXPECT_EQ(neighbour_similarity(all_lidar, lidar, {}, vision), 0.0);
  EXPECT_EQ(neighbour_similarity({}, lidar, both, vision), 0.0);
}

TEST(FilterByNeighbours, DropsACandidateWhoseSurroundingsDiffer) {
  const Plain plain;
  const auto count = plain.grid.patches.size();
  const PatchSignatures lidar(count, mix(1, 0));
  PatchSignatures vision(count, mix(1, 0));
  const auto odd = static_cast<std::size_t>(plain.grid.patch_at(7, 7));
  for (const std::size_t n : neighbours_of(plain.grid, odd, 1)) vision[n] = mix(0, 1);
  const auto fine = static_cast<std::size_t>(plain.grid.patch_at(2, 2));
  const std::vector<PatchCandidate> candidates = {{.vision_patch = fine, .correlation = 0.9},
                                                  {.vision_patch = odd, .correlation = 0.9}};
  const auto kept =
      filter_by_neighbours(fine, candidates, plain.grid, lidar, plain.grid, vision, 10, 0.6);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].vision_patch, fine);
  EXPECT_NEAR(kept[0].neighbour_score, 1.0, 1e-6);
}

}  // namespace
}  // namespace hybridfusion
