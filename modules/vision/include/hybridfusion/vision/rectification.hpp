#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/vision/camera.hpp>

#include <Eigen/Core>

namespace hybridfusion {

/// An ideal pinhole image (no distortion): pixel = focal * (x/z, y/z) + principal point.
struct PinholeGrid {
  int width_px = 0;
  int height_px = 0;
  double focal_px = 0.0;
  Eigen::Vector2d principal_point_px = Eigen::Vector2d::Zero();
};

/// A photo with its pose.
struct PosedCamera {
  CameraIntrinsics intrinsics = {};
  Rigid3 enu_from_camera = {};
};

/// Two photos turned about their centres until their image planes coincide and rows correspond
/// (HybridFusion III-A.2, Bouguet's rectification). x runs from the first to the second centre, z
/// along the mean optical axis made orthogonal to x, y = z cross x: any direction of the baseline
/// and any turn of the photos about their axes is handled alike.
///
/// A point at column x_left has x_right = x_left - k + num_disparities - 1 with the disparity
/// index k in [0, num_disparities) for depths between near and far; the right image is wider than
/// the left by num_disparities - 1 columns, so that no left column lacks candidates.
struct RectifiedGeometry {
  Eigen::Quaterniond enu_from_rectified = Eigen::Quaterniond::Identity();
  PinholeGrid left = {};
  PinholeGrid right = {};  ///< Same rows and focal length.
  double baseline_m = 0.0;
  int num_disparities = 0;        ///< A multiple of 4, plus 1: it halves twice.
  double first_column_gap = 0.0;  ///< focal * baseline / depth at k = 0.

  /// Depth along the common z axis at a (sub-pixel) disparity index.
  [[nodiscard]] double depth_m(double k) const {
    return left.focal_px * baseline_m / (k + first_column_gap);
  }
};

struct RectificationRequest {
  double focal_px = 0.0;  ///< Of the rectified images.
  double near_m = 0.0;    ///< Depths along the rectified axis to provide for; 0 < near < far.
  double far_m = 0.0;
};

/// Depth of a point along the axis that rectify() would choose for the pair.
[[nodiscard]] double rectified_depth_m(const PosedCamera& first,
                                       const PosedCamera& second,
                                       const Eigen::Vector3d& point_in_enu);

/// @returns kDegenerate when the centres coincide, the baseline runs along the view (rows cannot
/// correspond) or the two photos share no row.
[[nodiscard]] Expected<RectifiedGeometry> rectify(const PosedCamera& first,
                                                  const PosedCamera& second,
                                                  const RectificationRequest& request);

/// Direction (z = 1) of a pixel of a grid.
[[nodiscard]] inline Eigen::Vector3d ray_of(const PinholeGrid& grid, const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d xy = (pixel - grid.principal_point_px) / grid.focal_px;
  return {xy.x(), xy.y(), 1.0};
}
/// Pixel of a point in the grid's frame. @pre z > 0
[[nodiscard]] inline Eigen::Vector2d pixel_of(const PinholeGrid& grid, const Eigen::Vector3d& p) {
  return grid.focal_px * p.head<2>() / p.z() + grid.principal_point_px;
}

}  // namespace hybridfusion
