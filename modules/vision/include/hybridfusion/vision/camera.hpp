#pragma once

#include <hybridfusion/core/rigid3.hpp>

#include <Eigen/Core>

namespace hybridfusion {

/// Pinhole camera with Brown-Conrady distortion. Pixel centres follow OpenCV: the first pixel's
/// centre is (0, 0). Distorted normalised coordinates, with r^2 = x^2 + y^2:
///   x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
///   y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y
struct CameraIntrinsics {
  int width_px = 0;
  int height_px = 0;
  double focal_px = 0.0;
  Eigen::Vector2d principal_point_px = Eigen::Vector2d::Zero();
  double k1 = 0.0;
  double k2 = 0.0;
  double k3 = 0.0;
  double p1 = 0.0;
  double p2 = 0.0;
};

/// Distorts normalised image coordinates (x/z, y/z).
[[nodiscard]] Eigen::Vector2d distort(const CameraIntrinsics& camera,
                                      const Eigen::Vector2d& normalized);
/// Inverse of distort by fixed-point iteration.
[[nodiscard]] Eigen::Vector2d undistort(const CameraIntrinsics& camera,
                                        const Eigen::Vector2d& distorted);
/// Pixel of a point in the camera frame (x right, y down, z forward). @pre z > 0
[[nodiscard]] Eigen::Vector2d project(const CameraIntrinsics& camera,
                                      const Eigen::Vector3d& point_in_camera);
/// Undistorted normalised coordinates (x/z, y/z) of a pixel.
[[nodiscard]] Eigen::Vector2d unproject(const CameraIntrinsics& camera,
                                        const Eigen::Vector2d& pixel);

}  // namespace hybridfusion
