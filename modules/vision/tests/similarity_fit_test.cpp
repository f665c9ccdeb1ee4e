#include "similarity_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

const Sim3 kTruth{.rotation = Eigen::Quaterniond(
                      Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.2, -0.3, 1).normalized())),
                  .translation = {30.0, -20.0, 65.0},
                  .scale = 12.0};

enum class Layout : bool { kGrid, kLine };

std::vector<PositionPair> pairs_of(int count, double noise_m, Layout layout, std::uint64_t seed) {
  Random random(seed, "test/similarity");
  std::vector<PositionPair> pairs;
  for (int i = 0; i < count; ++i) {
    const double across = layout == Layout::kGrid ? 1.0 * (i % 4) : 0.0;
    // The map is level: what is in the world frame is its inverse image.
    const Eigen::Vector3d on_map(10.0 * (i / 4) + (layout == Layout::kLine ? 3.0 * i : 0.0),
                                 12.0 * across,
                                 65.0 + 0.3 * random.normal());
    PositionPair pair;
    pair.in_world = kTruth.inverse() * on_map;
    pair.in_enu =
        on_map + noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    pair.sigma_m = Eigen::Vector3d(1.5, 1.5, 5.0);
    pairs.push_back(pair);
  }
  return pairs;
}

double tilt_deg(const Sim3& enu_from_world) {
  const Eigen::Vector3d up = kTruth.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  return std::acos(std::min(1.0, (enu_from_world.rotation * up).z())) * 180.0 / M_PI;
}

TEST(LeastMedianSimilarity, IsNotMovedByAThirdOfWildPositions) {
  auto pairs = pairs_of(24, 0.0, Layout::kGrid, 1);
  for (std::size_t i = 0; i < pairs.size(); i += 3) pairs[i].in_enu += Eigen::Vector3d(80, -60, 40);
  const auto sim = least_median_similarity(pairs, Random(1, "test"));
  ASSERT_TRUE(sim);
  EXPECT_NEAR(sim->scale, kTruth.scale, 1e-6);
  EXPECT_LT((sim->translation - kTruth.translation).norm(), 1e-5);
}

TEST(LeastMedianSimilarity, LineIsRefused) {
  auto pairs = pairs_of(12, 0.0, Layout::kLine, 1);
  for (auto& pair : pairs) pair.in_world = Eigen::Vector3d(pair.in_enu.x() / 10.0, 0.0, 0.0);
  const auto sim = least_median_similarity(pairs, Random(1, "test"));
  ASSERT_FALSE(sim);
  EXPECT_EQ(sim.error().code, ErrorCode::kDegenerate);
}

TEST(LeastMedianSimilarity, TwoPositionsAreRefused) {
  const auto pairs = pairs_of(2, 0.0, Layout::kGrid, 1);
  EXPECT_EQ(least_median_similarity(pairs, Random(1, "test")).error().code,
            ErrorCode::kInsufficient);
}

TEST(UprightSimilarity, IgnoresADriftOfTheAltitudes) {
  auto pairs = pairs_of(24, 0.0, Layout::kGrid, 2);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs[i].in_enu.z() += 4.0 * static_cast<double>(i);
  const Eigen::Vector3d up = kTruth.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  const auto sim = least_median_upright_similarity(pairs, up, Random(1, "test"));
  ASSERT_TRUE(sim);
  EXPECT_LT(tilt_deg(*sim), 0.01);
  EXPECT_NEAR(sim->scale, kTruth.scale, 1e-6);
}

TEST(RefineSimilarity, WeighsDownOutliersAndReportsTheTiltThatIsLeft) {
  auto pairs = pairs_of(40, 0.5, Layout::kGrid, 3);
  pairs[7].in_enu += Eigen::Vector3d(40.0, 0.0, 0.0);
  const auto start = least_median_similarity(pairs, Random(1, "test"));
  ASSERT_TRUE(start);
  const SimilarityFit fit = refine_similarity(pairs, *start, std::nullopt);
  // 0.5 m over 40 positions within 90 m.
  EXPECT_NEAR(fit.enu_from_world.scale / kTruth.scale, 1.0, 0.01);
  EXPECT_LT(tilt_deg(fit.enu_from_world), 1.5);
  EXPECT_GT(fit.tilt_sigma_rad, 0.01);
  EXPECT_LT(fit.tilt_sigma_rad, 0.2);
  EXPECT_LT(fit.horizontal_ratio, 0.6);
}

TEST(RefineSimilarity, UpPriorFixesTheRollAboutALine) {
  const auto pairs = pairs_of(20, 0.2, Layout::kLine, 4);
  const UpPrior up{.up_in_world = kTruth.rotation.conjugate() * Eigen::Vector3d::UnitZ(),
                   .sigma_rad = 0.03};
  const auto start = least_median_upright_similarity(pairs, up.up_in_world, Random(1, "test"));
  ASSERT_TRUE(start);
  EXPECT_LT(tilt_deg(refine_similarity(pairs, *start, up).enu_from_world), 2.0);
}

}  // namespace
}  // namespace hybridfusion
