#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/camera.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// What is known of a camera before any photo is looked at.
struct CameraPrior {
  CameraIntrinsics intrinsics = {};
  double focal_sigma = 0.0;  ///< Relative standard deviation of the focal length.
  bool focal_guessed = false;
  double pixel_scale = 1.0;  ///< Stored pixels per pixel of the reduced photo, >= 1.
};

struct CameraSetup {
  std::vector<CameraPrior> cameras = {};
  std::vector<std::uint32_t> camera_of_photo = {};
  std::vector<std::string> warnings = {};
};

/// One camera per make, model, serial number, photo size and focal length. The focal length comes
/// from, in this order: the option, the factory calibration, the 35 mm equivalent (by the image
/// diagonal), the focal plane resolution, a table of sensor widths, 1.2 times the longest side.
/// Sources that disagree by more than 10 % give a warning.
[[nodiscard]] CameraSetup group_cameras(std::span<const PhotoMetadata> photos,
                                        const IntrinsicsOptions& options,
                                        int max_size_px);

}  // namespace hybridfusion
