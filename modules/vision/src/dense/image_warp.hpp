#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/rectification.hpp>

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace hybridfusion {

/// A photo as a work image: reduced to the size at which it is matched, RGB.
struct WorkImage {
  cv::Mat rgb = {};
  CameraIntrinsics intrinsics = {};  ///< Of the reduced image.
};

/// Area-averaged reduction to `max_size_px`; intrinsics follow (pixel centres at integers).
[[nodiscard]] WorkImage reduce(const Image8& photo,
                               const CameraIntrinsics& intrinsics,
                               int max_size_px);

/// Camera model of a photo at another resolution; a pixel's centre stays its centre.
[[nodiscard]] CameraIntrinsics scaled(const CameraIntrinsics& intrinsics,
                                      int width_px,
                                      int height_px);

/// Resamples the photo on an ideal grid that is turned against the camera: distortion and rotation
/// in one step. Where the photo has no data, `mask` is 0.
struct WarpedImage {
  cv::Mat rgb = {};
  cv::Mat mask = {};  ///< 8 bit, 255 where there is data.
};
[[nodiscard]] WarpedImage warp(const WorkImage& image,
                               const PinholeGrid& grid,
                               const Eigen::Quaterniond& camera_from_grid);

/// The undistorted grid that covers a photo at about its own resolution, same axes as the camera.
[[nodiscard]] PinholeGrid undistorted_grid(const CameraIntrinsics& intrinsics);

}  // namespace hybridfusion
