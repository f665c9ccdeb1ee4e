#pragma once

#include <hybridfusion/vision/camera.hpp>

#include <Eigen/Core>

namespace hybridfusion {

/// Order of the intrinsics in parameter vectors: f, cx, cy, k1, k2, k3, p1, p2.
inline constexpr int kNumIntrinsics = 8;
using IntrinsicsVector = Eigen::Matrix<double, kNumIntrinsics, 1>;

[[nodiscard]] IntrinsicsVector to_vector(const CameraIntrinsics& camera);
void from_vector(const IntrinsicsVector& values, CameraIntrinsics& camera);

struct Projection {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, 3> by_point;  ///< d pixel / d point_in_camera.
  Eigen::Matrix<double, 2, kNumIntrinsics> by_intrinsics;
};

/// project() with its derivatives. @pre point_in_camera.z() > 0
[[nodiscard]] Projection project_with_jacobian(const IntrinsicsVector& intrinsics,
                                               const Eigen::Vector3d& point_in_camera);

}  // namespace hybridfusion
