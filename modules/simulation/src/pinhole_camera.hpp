#pragma once

#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// True camera: pinhole with radial distortion, pixel (0, 0) is the centre of the first pixel.
///   x_d = x_u (1 + k1 r^2 + k2 r^4), r^2 = x_u^2 + y_u^2   (Brown 1971; OpenCV's model)
class PinholeCamera {
 public:
  PinholeCamera(int width_px,
                int height_px,
                double focal_px,
                Eigen::Vector2d principal_px,
                double k1,
                double k2);

  /// Direction (not normalised, z = 1) through a pixel position.
  [[nodiscard]] Eigen::Vector3d direction(double x_px, double y_px) const;
  /// Pixel of a point in the camera frame; false behind the camera, outside the image, or where the
  /// distortion folds back.
  [[nodiscard]] bool project(const Eigen::Vector3d& point_in_camera, Eigen::Vector2d& pixel) const;

  int width_px = 0;
  int height_px = 0;
  double focal_px = 0.0;
  Eigen::Vector2d principal_px = Eigen::Vector2d::Zero();
  double k1 = 0.0;
  double k2 = 0.0;

 private:
  std::vector<double> undistort_ = {};  ///< r_u / r_d over r_d^2, evenly spaced.
  double table_end_ = 0.0;
};

/// Focal length [px] that a reader of the EXIF arrives at: 35 mm equivalent by the diagonal.
[[nodiscard]] double exif_focal_px(const CameraOptions& options);

/// The camera of a flight: focal length and principal point off by a random amount.
[[nodiscard]] PinholeCamera make_true_camera(const CameraOptions& options, std::uint64_t seed);

}  // namespace hybridfusion
