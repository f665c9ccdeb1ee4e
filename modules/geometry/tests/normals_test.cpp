#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/normals.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

TEST(EstimateShapes, FindsTheNormalOfASlopedPlane) {
  Random random(1, "normals_test");
  std::vector<Eigen::Vector3f> points(400);
  for (auto& p : points) {
    const double x = random.uniform(-5, 5);
    const double y = random.uniform(-5, 5);
    p = Eigen::Vector3d(x, y, 0.5 * x).cast<float>();
  }
  const KdTree tree(points);
  const Eigen::Vector3f truth = Eigen::Vector3f(-0.5F, 0, 1).normalized();
  for (const PointShape& shape : estimate_shapes(points, tree, 10)) {
    EXPECT_NEAR(std::abs(shape.normal.dot(truth)), 1.0F, 1e-4F);
    EXPECT_LT(shape.curvature, 1e-4F);
  }
}

TEST(EstimateShapes, CoincidentPointsHaveNoNormal) {
  const std::vector<Eigen::Vector3f> points(5, Eigen::Vector3f(1, 2, 3));
  const KdTree tree(points);
  EXPECT_EQ(estimate_shapes(points, tree, 5).front().normal, Eigen::Vector3f::Zero());
}

}  // namespace
}  // namespace hybridfusion
