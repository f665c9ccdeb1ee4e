#include <hybridfusion/vision/camera.hpp>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

CameraIntrinsics wide_lens() {
  return {.width_px = 1600,
          .height_px = 1200,
          .focal_px = 1290.0,
          .principal_point_px = {801.5, 596.0},
          .k1 = -0.12,
          .k2 = 0.04,
          .k3 = -0.005,
          .p1 = 0.002,
          .p2 = -0.001};
}

TEST(Camera, PointOnTheAxisLandsOnThePrincipalPoint) {
  EXPECT_EQ(project(wide_lens(), {0.0, 0.0, 7.0}), Eigen::Vector2d(801.5, 596.0));
}

TEST(Camera, DistortionFollowsTheStatedPolynomialByHand) {
  // x = 0.5, y = 0: r2 = 0.25, radial = 1 - 0.03 + 0.0025 - 7.8125e-5,
  // x' = 0.5 radial + p2 (0.25 + 0.5), y' = p1 * 0.25.
  const Eigen::Vector2d d = distort(wide_lens(), {0.5, 0.0});
  EXPECT_NEAR(d.x(), 0.5 * (1.0 - 0.03 + 0.0025 - 7.8125e-5) - 0.001 * 0.75, 1e-15);
  EXPECT_NEAR(d.y(), 0.002 * 0.25, 1e-15);
}

TEST(Camera, UndistortInvertsDistortOverTheWholeImage) {
  const CameraIntrinsics camera = wide_lens();
  for (double y = -0.47; y <= 0.47; y += 0.094) {
    for (double x = -0.63; x <= 0.63; x += 0.09) {
      const Eigen::Vector2d n(x, y);
      EXPECT_LT((undistort(camera, distort(camera, n)) - n).norm(), 1e-10);
    }
  }
}

TEST(Camera, StronglyDistortedLensIsInvertedToo) {
  // Factory figures of a multispectral drone camera: k1 = -0.42.
  CameraIntrinsics camera = wide_lens();
  camera.k1 = -0.42275;
  camera.k2 = 0.3691;
  camera.k3 = -0.2643;
  const Eigen::Vector2d n(0.41, -0.33);
  EXPECT_LT((undistort(camera, distort(camera, n)) - n).norm(), 1e-9);
}

TEST(Camera, UnprojectGivesTheRayThatProjectsBack) {
  const CameraIntrinsics camera = wide_lens();
  const Eigen::Vector2d pixel(37.0, 1100.0);
  const Eigen::Vector2d ray = unproject(camera, pixel);
  EXPECT_LT((project(camera, Eigen::Vector3d(3.0 * ray.x(), 3.0 * ray.y(), 3.0)) - pixel).norm(),
            1e-6);
}

}  // namespace
}  // namespace hybridfusion
