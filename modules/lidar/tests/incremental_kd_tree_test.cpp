#include "incremental_kd_tree.hpp"

#include "slow_map.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::SlowMap;
using testing::sorted;
using testing::Thinning;
using Points = std::vector<Eigen::Vector3f>;

constexpr float kVoxel_m = 0.5F;

Points random_cloud(Random& random, std::size_t count, const Eigen::Vector3d& size_m) {
  Points points(count);
  for (Eigen::Vector3f& point : points) {
    const Eigen::Vector3d unit(random.uniform(), random.uniform(), random.uniform());
    point = unit.cwiseProduct(size_m).cast<float>();
  }
  return points;
}

/// A subtree is built again when its heavier side holds more than 0.6 of it, or 5/6 where the voxel
/// grid admits no better division, and an eighth of it has changed: no path exceeds this.
int max_depth(std::size_t size, double heavier_share) {
  return 2 + static_cast<int>(std::log(static_cast<double>(size) / 8.0) / -std::log(heavier_share));
}

TEST(IncrementalKdTree, FindsWhatLiesInABoxOrABall) {
  Random random(1, "test/kd_tree");
  IncrementalKdTree tree(kVoxel_m);
  SlowMap twin(kVoxel_m, Thinning::kNearestToCenter);
  for (int round = 0; round < 10; ++round) {
    const Points points = random_cloud(random, 800, {20.0, 20.0, 4.0});
    tree.insert(points);
    twin.insert(points);
    const MapBox gone{.min = points[0], .max = points[0] + Eigen::Vector3f(5.0F, 4.0F, 3.0F)};
    tree.erase_box(gone);
    twin.erase_if([&](const auto& point) { return gone.contains(point); });
    for (int i = 0; i < 20; ++i) {
      const Points corners = random_cloud(random, 2, {20.0, 20.0, 4.0});
      const MapBox box{.min = corners[0].cwiseMin(corners[1]),
                       .max = corners[0].cwiseMax(corners[1])};
      EXPECT_EQ(sorted(tree.within_box(box)),
                twin.points_if([&](const auto& point) { return box.contains(point); }));
      const auto radius_m = static_cast<float>(random.uniform(0.1, 12.0));
      EXPECT_EQ(sorted(tree.within_radius(corners[0], radius_m)),
                twin.points_if([&](const auto& point) {
                  return (point - corners[0]).squaredNorm() < radius_m * radius_m;
                }));
    }
  }
}

TEST(IncrementalKdTree, StaysBalancedWhenPointsComeInOrder) {
  IncrementalKdTree tree(kVoxel_m);
  for (int i = 0; i < 20'000; ++i) {
    tree.insert(Points{{kVoxel_m * static_cast<float>(i), 0.0F, 0.0F}});
  }
  ASSERT_EQ(tree.size(), 20'000U);
  EXPECT_LE(tree.depth(), max_depth(tree.size(), 0.6));
}

TEST(IncrementalKdTree, StaysBalancedWhereTheGridAdmitsNoMedian) {
  // Three lines that cross: on every axis two thirds of the points share a layer of voxels.
  IncrementalKdTree tree(kVoxel_m);
  for (int i = -3000; i < 3000; ++i) {
    const float at = kVoxel_m * static_cast<float>(i);
    tree.insert(Points{{at, 0.0F, 0.0F}, {0.0F, at, 0.0F}, {0.0F, 0.0F, at}});
  }
  ASSERT_EQ(tree.size(), 3U * 6000U - 2U);
  EXPECT_LE(tree.depth(), max_depth(tree.size(), 6.0 / 7.0));
}

TEST(IncrementalKdTree, StaysBalancedWhenOneSideIsErased) {
  Random random(2, "test/kd_tree");
  IncrementalKdTree tree(kVoxel_m);
  tree.insert(random_cloud(random, 40'000, {200.0, 200.0, 10.0}));
  for (float x = 0.0F; x < 190.0F; x += 1.0F) {
    tree.erase_box({.min = {x, 0.0F, -1.0F}, .max = {x + 1.0F, 300.0F, 11.0F}});
    if (tree.size() > 1000) {
      ASSERT_LE(tree.depth(), max_depth(2 * tree.size(), 0.6)) << x;  // half may be marked deleted
    }
  }
}

TEST(IncrementalKdTree, TakesFewBytesAPointAndNoMoreOnRevisits) {
  Random random(3, "test/kd_tree");
  IncrementalKdTree tree(kVoxel_m);
  // A street: ground and two fronts, seen piece by piece as one drives along.
  const auto drive = [&] {
    for (int i = 0; i < 200; ++i) {
      Points scan = random_cloud(random, 3000, {40.0, 24.0, 0.3});
      for (std::size_t k = 0; k < scan.size(); ++k) {
        scan[k].x() += 2.0F * static_cast<float>(i);
        if (k % 3 == 0) scan[k].z() = scan[k].y() / 2.0F;
        if (k % 3 == 0) scan[k].y() = k % 2 == 0 ? 0.0F : 24.0F;
      }
      tree.insert(scan);
    }
  };
  drive();
  const std::size_t size = tree.size();
  const std::size_t bytes = tree.num_bytes();
  EXPECT_GT(size, 50'000U);
  EXPECT_LE(bytes, 90 * size);
  for (int again = 0; again < 3; ++again) drive();
  // Voxels that the first passes missed still come in.
  EXPECT_LE(tree.size(), size + size / 4);
  EXPECT_LE(tree.num_bytes(), 90 * tree.size());
  EXPECT_LE(tree.num_bytes(), 2 * bytes);
}

TEST(IncrementalKdTree, UsesTheRoomOfErasedPointsAgain) {
  Random random(4, "test/kd_tree");
  IncrementalKdTree tree(kVoxel_m);
  std::size_t most_bytes = 0;
  for (int round = 0; round < 40; ++round) {
    const Points points = random_cloud(random, 5000, {60.0, 60.0, 3.0});
    tree.insert(points);
    tree.erase_box({.min = {0.0F, 0.0F, -1.0F}, .max = {60.0F, 59.0F, 9.0F}});
    if (round == 4) most_bytes = tree.num_bytes();
  }
  EXPECT_LE(tree.num_bytes(), 2 * most_bytes);
}

TEST(IncrementalKdTree, IsTheSameTreeAfterTheSameCalls) {
  const auto grown = [] {
    Random random(6, "test/kd_tree");
    IncrementalKdTree tree(kVoxel_m);
    for (int i = 0; i < 30; ++i) {
      const Points points = random_cloud(random, 700, {30.0, 30.0, 5.0});
      tree.insert(points);
      tree.erase_box({.min = points[0], .max = points[0] + Eigen::Vector3f::Constant(4.0F)});
    }
    return tree.points();
  };
  EXPECT_EQ(grown(), grown());
}

TEST(IncrementalKdTree, KeepsThePointNearestToTheCentreOfItsVoxel) {
  IncrementalKdTree tree(1.0);
  for (const float x : {0.9F, 0.55F, 0.3F}) tree.insert(Points{{x, 0.5F, 0.5F}});
  tree.insert(Points{{-0.4F, 0.5F, 0.5F}});
  tree.insert(Points{{0.1F, 0.5F, 0.5F}});
  EXPECT_EQ(sorted(tree.points()), (Points{{-0.4F, 0.5F, 0.5F}, {0.55F, 0.5F, 0.5F}}));
}

TEST(IncrementalKdTree, TakesTheMeanOfWhatOneScanBringsToAVoxel) {
  IncrementalKdTree tree(1.0);
  tree.insert(Points{{0.5F, 0.5F, 0.75F}, {0.75F, 0.25F, 0.75F}});
  EXPECT_EQ(tree.points(), (Points{{0.625F, 0.375F, 0.75F}}));
}

}  // namespace
}  // namespace hybridfusion
