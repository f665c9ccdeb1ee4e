#include "projection.hpp"

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

CameraIntrinsics lens() {
  return {.width_px = 1600,
          .height_px = 1200,
          .focal_px = 1290.0,
          .principal_point_px = {801.0, 597.0},
          .k1 = -0.2,
          .k2 = 0.08,
          .k3 = -0.01,
          .p1 = 0.002,
          .p2 = -0.003};
}

TEST(Projection, PixelEqualsThatOfTheCameraModel) {
  const Eigen::Vector3d point(1.5, -0.8, 4.0);
  EXPECT_LT((project_with_jacobian(to_vector(lens()), point).pixel - project(lens(), point)).norm(),
            1e-12);
}

TEST(Projection, JacobiansEqualCentralDifferences) {
  const Eigen::Vector3d point(1.5, -0.8, 4.0);
  const IntrinsicsVector intrinsics = to_vector(lens());
  const Projection p = project_with_jacobian(intrinsics, point);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d d = kStep * Eigen::Vector3d::Unit(k);
    const Eigen::Vector2d difference = (project_with_jacobian(intrinsics, point + d).pixel -
                                        project_with_jacobian(intrinsics, point - d).pixel) /
                                       (2.0 * kStep);
    EXPECT_LT((difference - p.by_point.col(k)).norm(), 1e-5) << k;
  }
  for (int k = 0; k < kNumIntrinsics; ++k) {
    const IntrinsicsVector d = kStep * IntrinsicsVector::Unit(k);
    const Eigen::Vector2d difference = (project_with_jacobian(intrinsics + d, point).pixel -
                                        project_with_jacobian(intrinsics - d, point).pixel) /
                                       (2.0 * kStep);
    EXPECT_LT((difference - p.by_intrinsics.col(k)).norm(), 1e-5) << k;
  }
}

TEST(Projection, VectorAndCameraConvertBothWays) {
  CameraIntrinsics copy;
  from_vector(to_vector(lens()), copy);
  EXPECT_EQ(to_vector(copy), to_vector(lens()));
}

}  // namespace
}  // namespace hybridfusion
