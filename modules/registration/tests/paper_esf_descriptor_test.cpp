#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/registration/esf_descriptor.hpp>

#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// A house corner: two walls and a floor, unequal sides.
Points corner(std::size_t count, std::uint64_t seed) {
  Random random(seed, "test");
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto u = static_cast<float>(random.uniform());
    const auto v = static_cast<float>(random.uniform());
    if (i % 3 == 0) points.emplace_back(9.0F * u, 9.0F * v, 0.0F);
    if (i % 3 == 1) points.emplace_back(9.0F * u, 0.0F, 6.0F * v);
    if (i % 3 == 2) points.emplace_back(0.0F, 5.0F * u, 6.0F * v);
  }
  return points;
}

Points ball(std::size_t count, std::uint64_t seed) {
  Random random(seed, "test");
  Points points;
  while (points.size() < count) {
    const Eigen::Vector3d p(
        random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    if (p.norm() <= 1.0) points.emplace_back(p.cast<float>());
  }
  return points;
}

double correlation(const Points& a, const Points& b) {
  const auto x = compute_esf(a);
  const auto y = compute_esf(b);
  EXPECT_TRUE(x && y);
  return pearson_correlation(centre_signature(*x), centre_signature(*y));
}

TEST(Esf, IsTheSameBytesForTheSameSeedAndNotForAnother) {
  const Points points = corner(3000, 1);
  const auto first = compute_esf(points, {.samples = 2000, .seed = 7});
  const auto again = compute_esf(points, {.samples = 2000, .seed = 7});
  const auto other = compute_esf(points, {.samples = 2000, .seed = 8});
  ASSERT_TRUE(first && again && other);
  EXPECT_EQ(*first, *again);
  EXPECT_NE(*first, *other);
}

TEST(Esf, FamiliesSumToAQuarterEach) {
  const auto signature = compute_esf(corner(3000, 1));
  ASSERT_TRUE(signature);
  const auto share = [&](std::size_t first, std::size_t last) {
    return std::accumulate(signature->begin() + static_cast<long>(first * 64),
                           signature->begin() + static_cast<long>(last * 64),
                           0.0);
  };
  EXPECT_NEAR(share(0, 3), 0.25, 1e-3);
  EXPECT_NEAR(share(3, 4), 0.25, 1e-3);
  EXPECT_NEAR(share(4, 7), 0.25, 1e-3);
  EXPECT_NEAR(share(7, 10), 0.25, 1e-3);
}

TEST(Esf, IsTheSameForAMovedAndScaledCloud) {
  const Points points = corner(3000, 1);
  const Eigen::Quaternionf turn(
      Eigen::AngleAxisf(0.7F, Eigen::Vector3f(0.2F, -0.4F, 1.0F).normalized()));
  Points moved;
  for (const auto& p : points) moved.emplace_back(3.0F * (turn * p) + Eigen::Vector3f(40, -7, 2));
  // Lengths, areas and angles are equal; lines that graze the axis-parallel lattice differ.
  EXPECT_GT(correlation(points, moved), 0.94);
  Points scaled;
  for (const auto& p : points) scaled.emplace_back(3.0F * p + Eigen::Vector3f(40, -7, 2));
  EXPECT_GT(correlation(points, scaled), 0.995);  // rounding moves a few points across cells
}

TEST(Esf, ResamplingTheSameShapeCorrelatesMoreThanAnotherShape) {
  const double same = correlation(corner(3000, 1), corner(3000, 2));
  const double other = correlation(corner(3000, 1), ball(3000, 3));
  EXPECT_GT(same, 0.97);
  EXPECT_LT(other, same - 0.2);
}

TEST(Esf, LinesInsideASolidBallAreInAndAcrossTwoClumpsAreNotIn) {
  const auto solid = compute_esf(ball(20000, 4));
  ASSERT_TRUE(solid);
  const double in = std::accumulate(solid->begin(), solid->begin() + 64, 0.0);
  EXPECT_GT(in, 0.2);  // of 0.25: nearly all lines stay inside
  Points clumps = ball(1000, 5);
  for (std::size_t i = 0; i < clumps.size(); i += 2) clumps[i].x() += 40.0F;
  const auto two = compute_esf(clumps);
  ASSERT_TRUE(two);
  const double mixed = std::accumulate(two->begin() + 128, two->begin() + 192, 0.0);
  EXPECT_NEAR(mixed, 0.125, 0.02);  // every second line crosses the gap
}

TEST(Esf, TooFewAndCollinearPointsAreRefused) {
  EXPECT_EQ(compute_esf(corner(99, 1)).error().code, ErrorCode::kInsufficient);
  Points with_nan = corner(120, 1);
  for (std::size_t i = 0; i < 30; ++i) with_nan[i].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compute_esf(with_nan).error().code, ErrorCode::kInsufficient);
  Points line;
  for (int i = 0; i < 200; ++i) line.emplace_back(Eigen::Vector3d(i, 2.0 * i, 3.0).cast<float>());
  EXPECT_EQ(compute_esf(line).error().code, ErrorCode::kDegenerate);
  EXPECT_EQ(compute_esf(Points(200, Eigen::Vector3f(1, 2, 3))).error().code,
            ErrorCode::kDegenerate);
}

TEST(Esf, FarFromTheOriginIsTheSameToFloatSpacing) {
  const Points points = corner(2000, 1);
  Points far = points;
  for (auto& p : far) p += Eigen::Vector3f(1e4F, -1e4F, 0.0F);  // spacing 1 mm there
  EXPECT_GT(correlation(points, far), 0.99);
}

TEST(PearsonCorrelation, IsOneForAnAffineCopyMinusOneForItsNegativeAndZeroForAConstant) {
  EsfSignature x{};
  EsfSignature y{};
  EsfSignature z{};
  EsfSignature constant{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = static_cast<float>(i % 13);
    y[i] = 2.0F * x[i] + 3.0F;
    z[i] = 1.0F - x[i];
    constant[i] = 0.1F;
  }
  const auto cx = centre_signature(x);
  EXPECT_NEAR(pearson_correlation(cx, centre_signature(y)), 1.0, 1e-6);
  EXPECT_NEAR(pearson_correlation(cx, centre_signature(z)), -1.0, 1e-6);
  EXPECT_EQ(pearson_correlation(cx, centre_signature(constant)), 0.0);
}

}  // namespace
}  // namespace hybridfusion
