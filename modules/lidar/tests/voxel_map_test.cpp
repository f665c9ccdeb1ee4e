#include "voxel_map.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

Eigen::Vector3f random_point(Random& random, double size_m) {
  return Eigen::Vector3d(random.uniform(-size_m, size_m),
                         random.uniform(-size_m, size_m),
                         random.uniform(-size_m / 4, size_m / 4))
      .cast<float>();
}

std::vector<float> brute_force(const std::vector<Eigen::Vector3f>& points,
                               const Eigen::Vector3f& query,
                               std::size_t count,
                               float radius_m) {
  std::vector<float> distances;
  for (const auto& point : points) {
    const float d = (point - query).squaredNorm();
    if (d < radius_m * radius_m) distances.push_back(d);
  }
  std::ranges::sort(distances);
  if (distances.size() > count) distances.resize(count);
  return distances;
}

TEST(VoxelMap, NearestEqualsBruteForceUnderRandomInsertsAndErasures) {
  Random random(7, "test/voxel_map");
  VoxelMap map(0.5);
  for (int round = 0; round < 8; ++round) {
    for (int i = 0; i < 1500; ++i) map.insert(random_point(random, 12.0));
    if (round % 2 == 1) map.erase_outside(random_point(random, 4.0), 8.0F);
    const auto points = map.points();
    EXPECT_EQ(points.size(), map.size());
    for (const float radius : {0.4F, 1.5F, 4.0F}) {
      for (int i = 0; i < 40; ++i) {
        const Eigen::Vector3f query = random_point(random, 14.0);
        MapNeighbors neighbors;
        map.nearest(query, 5, radius, neighbors);
        const auto expected = brute_force(points, query, 5, radius);
        ASSERT_EQ(static_cast<std::size_t>(neighbors.count), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
          EXPECT_EQ(neighbors.squared_distances_m2[k], expected[k]);
          EXPECT_EQ((neighbors.points[k] - query).squaredNorm(), expected[k]);
        }
      }
    }
  }
}

TEST(VoxelMap, KeepsTheMeanOfAVoxel) {
  VoxelMap map(1.0);
  map.insert({0.2F, 0.2F, 0.2F});
  map.insert({0.6F, 0.4F, 0.2F});
  ASSERT_EQ(map.size(), 1U);
  EXPECT_TRUE(map.points()[0].isApprox(Eigen::Vector3f(0.4F, 0.3F, 0.2F)));
  map.insert({-0.2F, 0.2F, 0.2F});
  EXPECT_EQ(map.size(), 2U);
}

TEST(VoxelMap, IgnoresPointsThatHaveNoPlace) {
  VoxelMap map(0.5);
  map.insert({std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F});
  map.insert({1e30F, 0.0F, 0.0F});
  EXPECT_EQ(map.size(), 0U);
  MapNeighbors neighbors;
  map.nearest({std::numeric_limits<float>::infinity(), 0.0F, 0.0F}, 5, 1.0F, neighbors);
  EXPECT_EQ(neighbors.count, 0);
}

TEST(VoxelMap, GivesMemoryBackWhenItForgets) {
  Random random(8, "test/voxel_map");
  VoxelMap map(0.5);
  for (int i = 0; i < 50'000; ++i) map.insert(random_point(random, 100.0));
  const std::size_t before = map.num_bytes();
  map.erase_outside(Eigen::Vector3f::Zero(), 10.0F);
  EXPECT_LT(map.num_bytes(), before / 10);
  EXPECT_GT(map.size(), 0U);
}

}  // namespace
}  // namespace hybridfusion
