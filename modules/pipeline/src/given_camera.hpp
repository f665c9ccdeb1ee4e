#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/vision/camera.hpp>

#include <array>

#include <Eigen/Core>

namespace hybridfusion {

/// A camera of COLMAP's OPENCV family whose lens CameraIntrinsics does not hold: two focal lengths
/// or a rational distortion, with r^2 = x^2 + y^2 and
/// R = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6):
///   x' = x R + 2 p1 x y + p2 (r^2 + 2 x^2),  y' = y R + p1 (r^2 + 2 y^2) + 2 p2 x y
/// The first pixel's centre is (0, 0).
struct GivenCamera {
  int width_px = 0;
  int height_px = 0;
  Eigen::Array2d focal_px = Eigen::Array2d::Zero();
  Eigen::Array2d principal_point_px = Eigen::Array2d::Zero();
  std::array<double, 6> k = {};
  std::array<double, 2> p = {};

  /// Pixel of normalised coordinates (x/z, y/z).
  [[nodiscard]] Eigen::Vector2d pixel_of(const Eigen::Vector2d& normalized) const;
  /// Normalised coordinates of a pixel, by fixed-point iteration.
  [[nodiscard]] Eigen::Vector2d normalized_of(const Eigen::Vector2d& pixel) const;
};

/// @returns kParse naming the model for one of another family or with other parameters.
[[nodiscard]] Expected<GivenCamera> given_camera(const ColmapCamera& camera);

/// A camera of the same size without distortion, every pixel of which the given one sees.
[[nodiscard]] CameraIntrinsics undistorted_intrinsics(const GivenCamera& camera);

/// The photo as `target` would have taken it, by linear interpolation.
[[nodiscard]] Image8 undistorted_image(const Image8& photo,
                                       const GivenCamera& camera,
                                       const CameraIntrinsics& target);

}  // namespace hybridfusion
