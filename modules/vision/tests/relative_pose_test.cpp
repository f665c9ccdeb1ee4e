#include "relative_pose.hpp"

#include "five_point.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

const Rigid3 kSecondFromFirst{
    .rotation = Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, -1).normalized())),
    .translation = Eigen::Vector3d(0.9, -0.3, 0.2).normalized()};

struct TwoViews {
  std::vector<Eigen::Vector2d> first;
  std::vector<Eigen::Vector2d> second;
};

TwoViews two_views(int count, double noise, double outliers, bool planar = false) {
  Random random(7, "test/two_views");
  TwoViews views;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d point(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(4, 9));
    if (planar) point.z() = 6.0 + 0.2 * point.x();
    const auto noisy = [&](const Eigen::Vector3d& p) -> Eigen::Vector2d {
      return p.hnormalized() + noise * Eigen::Vector2d(random.normal(), random.normal());
    };
    views.first.push_back(noisy(point));
    views.second.push_back(noisy(kSecondFromFirst * point));
    if (random.uniform() < outliers) {
      views.second.back() = {random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)};
    }
  }
  return views;
}

TEST(FivePoint, OneSolutionIsTheTrueEssentialMatrix) {
  const TwoViews views = two_views(5, 0.0, 0.0);
  std::array<Eigen::Vector2d, 5> a;
  std::array<Eigen::Vector2d, 5> b;
  std::copy_n(views.first.begin(), 5, a.begin());
  std::copy_n(views.second.begin(), 5, b.begin());
  const Eigen::Matrix3d truth = essential_of(kSecondFromFirst).normalized();
  double nearest = 1e9;
  for (const Eigen::Matrix3d& e : essential_from_five_points(a, b)) {
    nearest = std::min({nearest, (e - truth).norm(), (e + truth).norm()});
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(b[i].homogeneous().dot(e * a[i].homogeneous()), 0.0, 1e-9);
    }
  }
  EXPECT_LT(nearest, 1e-7);
}

TEST(FivePoint, RepeatedPointsGiveNoSolutionsInsteadOfNan) {
  std::array<Eigen::Vector2d, 5> a;
  a.fill({0.1, 0.2});
  for (const Eigen::Matrix3d& e : essential_from_five_points(a, a)) EXPECT_TRUE(e.allFinite());
}

TEST(RelativePose, IsFoundAmongFortyPercentOutliers) {
  const TwoViews views = two_views(400, 0.0003, 0.4);
  const auto pose =
      estimate_relative_pose(views.first, views.second, {.max_error = 0.0015}, Random(1, "test"));
  ASSERT_TRUE(pose);
  EXPECT_LT(rotation_distance_rad(pose->second_from_first.rotation, kSecondFromFirst.rotation),
            0.001);
  EXPECT_LT((pose->second_from_first.translation - kSecondFromFirst.translation).norm(), 0.005);
  EXPECT_GT(pose->inliers.size(), 220U);
}

TEST(RelativePose, PlaneIsExplainedByOneOfItsTwoPoses) {
  // A plane seen twice admits two poses with all points in front (Longuet-Higgins 1986): the
  // matches agree with either, and which one is true needs a third view.
  const TwoViews views = two_views(300, 0.0003, 0.1, true);
  const auto pose =
      estimate_relative_pose(views.first, views.second, {.max_error = 0.0015}, Random(1, "test"));
  ASSERT_TRUE(pose);
  EXPECT_GT(pose->inliers.size(), 260U);
}

TEST(RelativePose, TooFewAgreeingMatchesGiveNothing) {
  const TwoViews views = two_views(60, 0.0003, 1.0);
  EXPECT_FALSE(estimate_relative_pose(
      views.first, views.second, {.max_error = 0.001, .min_inliers = 40}, Random(1, "test")));
}

TEST(HomographyShare, TellsAPlaneFromASceneWithDepth) {
  const TwoViews plane = two_views(200, 0.0002, 0.0, true);
  const TwoViews depth = two_views(200, 0.0002, 0.0, false);
  EXPECT_GT(homography_share(plane.first, plane.second, 0.0015), 0.95);
  EXPECT_LT(homography_share(depth.first, depth.second, 0.0015), 0.5);
}

}  // namespace
}  // namespace hybridfusion
