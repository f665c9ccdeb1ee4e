#include <hybridfusion/core/random.hpp>
#include <hybridfusion/evaluation/surface_distance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Eigen::Vector3f random_point(Random& random, double extent_m) {
  return Eigen::Vector3d(random.uniform(-extent_m, extent_m),
                         random.uniform(-extent_m, extent_m),
                         random.uniform(-extent_m, extent_m))
      .cast<float>();
}

Mesh random_mesh(std::uint32_t count, double edge_m) {
  Random random(5, "mesh");
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Eigen::Vector3f base = random_point(random, 20.0);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(base + random_point(random, edge_m));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(TriangleDistance, IsRightInsideAtEdgesAndAtCorners) {
  const Eigen::Vector3f a(0, 0, 0);
  const Eigen::Vector3f b(2, 0, 0);
  const Eigen::Vector3f c(0, 2, 0);
  EXPECT_FLOAT_EQ(squared_distance_m2({0.5F, 0.5F, 3.0F}, a, b, c), 9.0F);
  EXPECT_FLOAT_EQ(squared_distance_m2({1.0F, -1.0F, 0.0F}, a, b, c), 1.0F);
  EXPECT_FLOAT_EQ(squared_distance_m2({2.0F, 2.0F, 0.0F}, a, b, c), 2.0F);
  EXPECT_FLOAT_EQ(squared_distance_m2({-3.0F, -4.0F, 0.0F}, a, b, c), 25.0F);
}

TEST(TriangleDistance, TreatsADegenerateTriangleAsASegmentOrAPoint) {
  const Eigen::Vector3f a(0, 0, 0);
  const Eigen::Vector3f b(1, 0, 0);
  EXPECT_FLOAT_EQ(squared_distance_m2({0.5F, 2.0F, 0.0F}, a, b, b), 4.0F);
  EXPECT_FLOAT_EQ(squared_distance_m2({0.0F, 0.0F, 3.0F}, a, a, a), 9.0F);
}

TEST(SurfaceDistance, EqualsBruteForceOnRandomTriangles) {
  const Mesh mesh = random_mesh(3000, 2.0);
  const auto surface = SurfaceDistance::build(mesh.vertices, mesh.triangles);
  ASSERT_TRUE(surface);
  Random random(6, "queries");
  for (int q = 0; q < 500; ++q) {
    const Eigen::Vector3f query = random_point(random, q % 5 == 0 ? 200.0 : 22.0);
    float best_m2 = std::numeric_limits<float>::infinity();
    for (const auto& t : mesh.triangles) {
      best_m2 = std::min(best_m2,
                         squared_distance_m2(
                             query, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
    }
    const SurfacePoint nearest = surface->nearest(query);
    // The boxes and the triangles round differently: float spacing at 200 m is 1.5e-5 m.
    EXPECT_NEAR(nearest.distance_m, std::sqrt(best_m2), 2e-5F * (1.0F + std::sqrt(best_m2)));
    const auto& t = mesh.triangles[nearest.triangle];
    EXPECT_FLOAT_EQ(nearest.distance_m,
                    std::sqrt(squared_distance_m2(
                        query, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])));
  }
}

TEST(SurfaceDistance, RefusesMeshesThatCannotBeMeasured) {
  const std::vector<Eigen::Vector3f> vertices = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<std::array<std::uint32_t, 3>> bad = {{0, 1, 2}};
  EXPECT_EQ(SurfaceDistance::build(vertices, bad).error().code, ErrorCode::kParse);
  EXPECT_EQ(SurfaceDistance::build(vertices, {}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
