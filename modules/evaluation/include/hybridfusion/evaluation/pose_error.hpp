#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <cstddef>
#include <span>

namespace hybridfusion {

/// How far estimated camera poses are from the true ones, in three frames of judgement.
struct CameraErrors {
  std::size_t num_cameras = 0;
  double absolute_rmse_m = 0.0;  ///< Centres as delivered: georeference and shape together.
  double absolute_horizontal_rmse_m = 0.0;
  double absolute_vertical_rmse_m = 0.0;
  double rigid_rmse_m = 0.0;         ///< After the best rotation and translation.
  double similarity_rmse_m = 0.0;    ///< After the best similarity: shape alone.
  double scale_error = 0.0;          ///< Estimated size over true size - 1.
  double tilt_deg = 0.0;             ///< Angle between the estimate's up and the true up.
  double rotation_median_deg = 0.0;  ///< Camera orientations after the similarity.
  double rotation_max_deg = 0.0;
  Rigid3 truth_from_estimate_rigid = {};
  Sim3 truth_from_estimate = {};
};

/// @param truth_from_camera, estimate_from_camera  The same cameras in the same order.
/// @returns kInsufficient below 3 cameras, kDegenerate when their centres lie on one line.
[[nodiscard]] Expected<CameraErrors> camera_errors(std::span<const Rigid3> truth_from_camera,
                                                   std::span<const Rigid3> estimate_from_camera);

}  // namespace hybridfusion
