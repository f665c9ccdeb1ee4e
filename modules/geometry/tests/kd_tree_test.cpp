#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

std::vector<Eigen::Vector3f> random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed, "kd_tree_test");
  std::vector<Eigen::Vector3f> points(count);
  for (auto& p : points) {
    p = Eigen::Vector3d(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-1, 1))
            .cast<float>();
  }
  return points;
}

TEST(KdTree, AgreesWithBruteForce) {
  const auto points = random_points(500, 1);
  const KdTree tree(points);
  std::vector<Neighbor> found;
  for (const Eigen::Vector3f& query : random_points(50, 2)) {
    std::vector<float> brute;
    for (const auto& p : points) brute.push_back((p - query).squaredNorm());
    std::ranges::sort(brute);
    tree.nearest(query, 7, found);
    ASSERT_EQ(found.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_FLOAT_EQ(found[i].squared_distance_m2, brute[i]);
    for (const float radius_m : {0.3F, 1.0F, 3.0F}) {
      const auto inside = static_cast<std::size_t>(
          std::ranges::count_if(brute, [&](float d2) { return d2 < radius_m * radius_m; }));
      tree.nearest(query, 7, radius_m, found);
      ASSERT_EQ(found.size(), std::min<std::size_t>(7, inside));
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_FLOAT_EQ(found[i].squared_distance_m2, brute[i]);
      }
    }
    tree.within(query, 1.0F, found);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(found.size()),
              std::ranges::count_if(brute, [](float d2) { return d2 < 1.0F; }));
  }
}

TEST(KdTree, AnEmptyTreeFindsNothing) {
  const KdTree tree({});
  std::vector<Neighbor> found(3);
  tree.nearest({0, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
  tree.nearest({0, 0, 0}, 3, 1.0F, found);
  EXPECT_TRUE(found.empty());
  EXPECT_TRUE(std::isinf(tree.nearest(Eigen::Vector3f(0, 0, 0)).squared_distance_m2));
}

TEST(KdTree, DuplicatedPointsAreAllFound) {
  const std::vector<Eigen::Vector3f> points(40, Eigen::Vector3f(1, 1, 1));
  const KdTree tree(points);
  std::vector<Neighbor> found;
  tree.within({1, 1, 1}, 0.1F, found);
  EXPECT_EQ(found.size(), 40U);
}

}  // namespace
}  // namespace hybridfusion
