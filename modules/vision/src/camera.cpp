#include <hybridfusion/vision/camera.hpp>

#include <Eigen/Geometry>

namespace hybridfusion {

Eigen::Vector2d distort(const CameraIntrinsics& camera, const Eigen::Vector2d& normalized) {
  const double x = normalized.x();
  const double y = normalized.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (camera.k1 + r2 * (camera.k2 + r2 * camera.k3));
  return {x * radial + 2.0 * camera.p1 * x * y + camera.p2 * (r2 + 2.0 * x * x),
          y * radial + camera.p1 * (r2 + 2.0 * y * y) + 2.0 * camera.p2 * x * y};
}

Eigen::Vector2d undistort(const CameraIntrinsics& camera, const Eigen::Vector2d& distorted) {
  // Brown's model contracts for every lens used here, so that n <- d - (distort(n) - n) converges;
  // the cap only matters far outside the image.
  constexpr int kMaxIterations = 50;
  constexpr double kTolerance = 1e-12;
  Eigen::Vector2d normalized = distorted;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector2d step = distorted - distort(camera, normalized);
    normalized += step;
    if (step.squaredNorm() < kTolerance * kTolerance) break;
  }
  return normalized;
}

Eigen::Vector2d project(const CameraIntrinsics& camera, const Eigen::Vector3d& point_in_camera) {
  return camera.focal_px * distort(camera, point_in_camera.hnormalized()) +
         camera.principal_point_px;
}

Eigen::Vector2d unproject(const CameraIntrinsics& camera, const Eigen::Vector2d& pixel) {
  return undistort(camera, (pixel - camera.principal_point_px) / camera.focal_px);
}

}  // namespace hybridfusion
