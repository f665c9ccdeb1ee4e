#pragma once

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/camera.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct ResectionOptions {
  double max_error_px = 4.0;  ///< Pixels of the photo as stored.
  int min_inliers = 20;
  int max_iterations = 1000;
};

struct Resection {
  Rigid3 world_from_camera = {};
  std::vector<std::uint32_t> inliers = {};
};

/// Pose of a calibrated camera from pixels of known points: RANSAC over three-point samples with
/// twice the error limit, then Gauss-Newton on all that agree, then the limit itself.
/// @returns nullopt below options.min_inliers.
[[nodiscard]] std::optional<Resection> resect_camera(const CameraIntrinsics& camera,
                                                     std::span<const Eigen::Vector2d> pixels,
                                                     std::span<const Eigen::Vector3d> points,
                                                     const ResectionOptions& options,
                                                     Random random);

/// Camera poses that see three points along three normalised image points (Grunert's quartic, in
/// the form of Haralick et al. 1994). Up to four.
[[nodiscard]] std::vector<Rigid3> world_from_camera_by_three_points(
    std::span<const Eigen::Vector2d, 3> normalized, std::span<const Eigen::Vector3d, 3> points);

}  // namespace hybridfusion
