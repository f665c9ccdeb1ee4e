#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/rectification.hpp>

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace hybridfusion {

/// A photo as a work image: reduced to the size at which it is matched.
struct WorkImage {
  cv::Mat rgb = {};
  cv::Mat grey = {};
  CameraIntrinsics intrinsics = {};  ///< Of the reduced image.
};

/// Area-averaged reduction to `max_size_px`; intrinsics follow (pixel centres at integers).
[[nodiscard]] WorkImage reduce(const Image8& photo,
                               const CameraIntrinsics& intrinsics,
                               int max_size_px);

/// Camera model of a photo at another resolution, whose longer side says the scale (the shorter one
/// is rounded); a pixel's centre stays its centre.
[[nodiscard]] CameraIntrinsics scaled(const CameraIntrinsics& intrinsics,
                                      int width_px,
                                      int height_px);

/// Where the pixels of an ideal grid that is turned against the camera lie in the photo: distortion
/// and rotation in one step. Where the photo has no data, `mask` is 0.
struct WarpMap {
  cv::Mat source = {};  ///< Two floats a pixel: its position in the photo.
  cv::Mat mask = {};    ///< 8 bit, 255 where there is data.
};
[[nodiscard]] WarpMap warp_map(const CameraIntrinsics& camera,
                               const PinholeGrid& grid,
                               const Eigen::Quaterniond& camera_from_grid);

/// The photo at the positions of the map, bilinear.
[[nodiscard]] cv::Mat resample(const cv::Mat& photo, const WarpMap& map);

/// The undistorted grid that encloses a whole photo at about its own resolution, same axes as the
/// camera: larger than the photo for a barrel lens, with pixels without data along its border.
[[nodiscard]] PinholeGrid undistorted_grid(const CameraIntrinsics& intrinsics);

}  // namespace hybridfusion
