#include "local_map.hpp"

#include "slow_map.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using testing::SlowMap;
using testing::sorted;
using testing::Thinning;
using Points = std::vector<Eigen::Vector3f>;

constexpr float kVoxel_m = 0.5F;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Eigen::Vector3f random_point(Random& random, double size_m) {
  return Eigen::Vector3d(random.uniform(-size_m, size_m),
                         random.uniform(-size_m, size_m),
                         random.uniform(-size_m / 4, size_m / 4))
      .cast<float>();
}

/// A cloud, a wall, a line, or copies of one point: what makes trees lean and cells crowd.
Points random_batch(Random& random) {
  const Eigen::Vector3f center = random_point(random, 10.0);
  const std::uint32_t shape = random.index(4);
  const int axis = static_cast<int>(random.index(3));
  Points points(1 + random.index(400));
  for (Eigen::Vector3f& point : points) {
    point = center;
    const Eigen::Vector3f offset = random_point(random, 6.0);
    if (shape == 0) point += offset;
    if (shape == 1) point += offset - offset[axis] * Eigen::Vector3f::Unit(axis);
    if (shape == 2) point += 2.0F * offset[0] * Eigen::Vector3f::Unit(axis);
  }
  return points;
}

template <class Map>
struct LocalMaps : ::testing::Test {
  Map map{kVoxel_m};
  SlowMap twin{kVoxel_m,
               std::is_same_v<Map, VoxelMap> ? Thinning::kMean : Thinning::kNearestToCenter};

  void insert(const Points& points) {
    map.insert(points);
    twin.insert(points);
  }
  void erase_box(const MapBox& box) {
    map.erase_box(box);
    twin.erase_if([&](const Eigen::Vector3f& point) { return box.contains(point); });
  }
  void erase_outside(const Eigen::Vector3f& center, float half_side_m) {
    map.erase_outside(center, half_side_m);
    twin.erase_if([&](const Eigen::Vector3f& point) {
      return (point - center).cwiseAbs().maxCoeff() > half_side_m;
    });
  }
  void expect_same_points() {
    ASSERT_EQ(sorted(map.points()), twin.points());
    ASSERT_EQ(map.points().size(), map.size());
  }
  void expect_same_neighbors(const Eigen::Vector3f& query, int count, float radius_m) {
    MapNeighbors neighbors;
    map.nearest(query, count, radius_m, neighbors);
    const auto expected = twin.nearest(query, static_cast<std::size_t>(count), radius_m);
    ASSERT_EQ(static_cast<std::size_t>(neighbors.count), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_EQ(neighbors.squared_distances_m2[k], expected[k]);
      ASSERT_EQ((neighbors.points[k] - query).squaredNorm(), expected[k]);
    }
  }
};
using Structures = ::testing::Types<VoxelMap, IncrementalKdTree>;
TYPED_TEST_SUITE(LocalMaps, Structures);

TYPED_TEST(LocalMaps, AgreeWithTheirSlowTwinUnderRandomOperations) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE(seed);
    Random random(seed, "test/local_map");
    this->map = TypeParam(kVoxel_m);
    this->twin.erase_if([](const auto&) { return true; });
    for (int step = 0; step < 120; ++step) {
      const std::uint32_t operation = random.index(10);
      if (operation < 6) {
        this->insert(random_batch(random));
      } else if (operation < 8) {
        this->insert({random_point(random, 12.0)});
      } else if (operation == 8) {
        const Eigen::Vector3f corner = random_point(random, 14.0);
        const Eigen::Vector3f size = random_point(random, 12.0).cwiseAbs();
        this->erase_box({.min = corner, .max = corner + size});
      } else if (random.index(4) == 0) {
        this->erase_outside(random_point(random, 4.0), 11.0F);
      }
      ASSERT_NO_FATAL_FAILURE(this->expect_same_points()) << step;
      for (int i = 0; i < 5; ++i) {
        const float radius_m = i == 4 ? 8.0F : static_cast<float>(random.uniform(0.1, 3.0));
        const int count = 1 + static_cast<int>(random.index(MapNeighbors::kCapacity));
        ASSERT_NO_FATAL_FAILURE(
            this->expect_same_neighbors(random_point(random, 16.0), count, radius_m))
            << step;
      }
    }
  }
}

TYPED_TEST(LocalMaps, AnswerWithNothingWhenEmpty) {
  this->expect_same_neighbors({1.0F, 2.0F, 3.0F}, 5, 10.0F);
  this->erase_box({.min = {-1.0F, -1.0F, -1.0F}, .max = {1.0F, 1.0F, 1.0F}});
  this->erase_outside(Eigen::Vector3f::Zero(), 1.0F);
  this->insert({});
  EXPECT_EQ(this->map.size(), 0U);
  EXPECT_TRUE(this->map.points().empty());
}

TYPED_TEST(LocalMaps, GiveTheFewPointsThereAre) {
  this->insert({{1.0F, 2.0F, 3.0F}});
  this->expect_same_neighbors({1.1F, 2.0F, 3.0F}, 5, 1.0F);
  this->insert({{-4.0F, 0.0F, 0.0F}, {2.0F, 2.0F, 3.0F}});
  this->expect_same_neighbors({1.1F, 2.0F, 3.0F}, 8, 30.0F);
}

TYPED_TEST(LocalMaps, KeepOneOfManyDuplicates) {
  this->insert(Points(5000, {7.3F, -2.2F, 0.1F}));
  EXPECT_EQ(this->map.size(), 1U);
  this->expect_same_points();
}

TYPED_TEST(LocalMaps, IgnorePointsThatHaveNoPlace) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  this->map.insert(Points{{kNan, 0.0F, 0.0F},
                          {0.0F, kNan, 0.0F},
                          {0.0F, 0.0F, kNan},
                          {1e30F, 0.0F, 0.0F},
                          {0.0F, -kInfinity, 0.0F}});
  EXPECT_EQ(this->map.size(), 0U);
  this->map.insert(Points{{1.0F, 1.0F, 1.0F}});
  MapNeighbors neighbors;
  this->map.nearest({kInfinity, 0.0F, 0.0F}, 5, 1.0F, neighbors);
  EXPECT_EQ(neighbors.count, 0);
  this->map.nearest({kNan, 1.0F, 1.0F}, 5, 9.0F, neighbors);
  EXPECT_EQ(neighbors.count, 0);
}

TYPED_TEST(LocalMaps, LeaveThePointsOnTheUpperSidesOfAnErasedBox) {
  this->insert({{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 1.0F}});
  this->erase_box({.min = {0.0F, 0.0F, 0.0F}, .max = {1.0F, 1.0F, 1.0F}});
  EXPECT_EQ(this->map.size(), 3U);
  this->expect_same_points();
}

TYPED_TEST(LocalMaps, CanBeFilledAgainAfterAllWasErased) {
  Random random(5, "test/local_map");
  for (int round = 0; round < 3; ++round) {
    Points points(2000);
    for (Eigen::Vector3f& point : points) point = random_point(random, 10.0);
    this->insert(points);
    this->expect_same_points();
    this->erase_box({.min = {-99.0F, -99.0F, -99.0F}, .max = {99.0F, 99.0F, 99.0F}});
    EXPECT_EQ(this->map.size(), 0U);
  }
}

TYPED_TEST(LocalMaps, GiveMemoryBackWhenTheyForget) {
  Random random(8, "test/local_map");
  Points points(50'000);
  for (Eigen::Vector3f& point : points) point = random_point(random, 100.0);
  this->map.insert(points);
  const std::size_t before = this->map.num_bytes();
  this->map.erase_outside(Eigen::Vector3f::Zero(), 10.0F);
  EXPECT_LT(this->map.num_bytes(), before / 10);
  EXPECT_GT(this->map.size(), 0U);
}

TYPED_TEST(LocalMaps, RefuseMoreNeighborsThanTheyHold) {
  MapNeighbors neighbors;
  const auto ask = [&](int count) {
    this->map.nearest(Eigen::Vector3f::Zero(), count, 1.0F, neighbors);
  };
  EXPECT_THROW(ask(0), std::logic_error);
  EXPECT_THROW(ask(MapNeighbors::kCapacity + 1), std::logic_error);
}

TEST(VoxelMap, KeepsTheMeanOfAVoxel) {
  VoxelMap map(1.0);
  map.insert(Points{{0.2F, 0.2F, 0.2F}, {0.6F, 0.4F, 0.2F}});
  ASSERT_EQ(map.size(), 1U);
  EXPECT_TRUE(map.points()[0].isApprox(Eigen::Vector3f(0.4F, 0.3F, 0.2F)));
  map.insert(Points{{-0.2F, 0.2F, 0.2F}});
  EXPECT_EQ(map.size(), 2U);
}

TEST(LocalMap, IsOfTheStructureThatIsNamed) {
  LocalMap hash({.structure = "hash", .voxel_m = 1.0});
  LocalMap tree({.structure = "ikdtree", .voxel_m = 1.0});
  const Points points{{0.2F, 0.2F, 0.2F}, {0.6F, 0.4F, 0.2F}};
  hash.insert(points);
  tree.insert(points);
  const Points closer{{0.6F, 0.5F, 0.5F}};
  hash.insert(closer);
  tree.insert(closer);
  EXPECT_TRUE(hash.points()[0].isApprox(Eigen::Vector3f(1.4F / 3.0F, 1.1F / 3.0F, 0.3F)));
  EXPECT_EQ(tree.points(), closer);
  EXPECT_THROW(LocalMap({.structure = "octree"}), std::logic_error);
}

}  // namespace
}  // namespace hybridfusion
