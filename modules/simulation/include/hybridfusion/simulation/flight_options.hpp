#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// The drone's camera.
struct CameraOptions {
  int width_px = 1600;
  int height_px = 1200;
  int samples_per_pixel = 4;
  double focal_35mm = 28.0;
  double focal_error_sd = 0.005;
  double k1 = -0.045;
  double k2 = 0.018;
  double principal_point_sd_px = 3.0;
  double vignetting = 0.22;
  double noise_sd = 2.0;
  int jpeg_quality = 95;
};
template <>
struct OptionFields<CameraOptions> {
  using T = CameraOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::width_px,
            {.key = "width_px",
             .unit = "px",
             .min = 64,
             .max = 12000,
             .doc = "Photo width.",
             .source = "ours"}},
      Field{&T::height_px,
            {.key = "height_px",
             .unit = "px",
             .min = 64,
             .max = 12000,
             .doc = "Photo height.",
             .source = "ours"}},
      Field{&T::samples_per_pixel,
            {.key = "samples_per_pixel",
             .unit = "1",
             .min = 1,
             .max = 64,
             .doc = "Rays per pixel.",
             .source = "ours"}},
      Field{&T::focal_35mm,
            {.key = "focal_35mm",
             .unit = "mm",
             .min = 10,
             .max = 200,
             .doc = "35 mm equivalent by the diagonal, as EXIF says.",
             .source = "CIPA DC-008"}},
      Field{&T::focal_error_sd,
            {.key = "focal_error_sd",
             .unit = "1",
             .min = 0,
             .max = 0.1,
             .doc = "How far the true focal length is off the EXIF value, relative, 1 sigma.",
             .source = "ours"}},
      Field{&T::k1,
            {.key = "k1",
             .unit = "1",
             .min = -0.2,
             .max = 0.2,
             .doc = "Radial distortion (Brown).",
             .source = "ours"}},
      Field{&T::k2,
            {.key = "k2",
             .unit = "1",
             .min = -0.2,
             .max = 0.2,
             .doc = "Radial distortion (Brown).",
             .source = "ours"}},
      Field{&T::principal_point_sd_px,
            {.key = "principal_point_sd_px",
             .unit = "px",
             .min = 0,
             .max = 100,
             .doc = "Offset of the principal point from the image centre per axis, 1 sigma.",
             .source = "ours"}},
      Field{&T::vignetting,
            {.key = "vignetting",
             .unit = "1",
             .min = 0,
             .max = 0.9,
             .doc = "Loss of light in the corners.",
             .source = "ours"}},
      Field{&T::noise_sd,
            {.key = "noise_sd",
             .unit = "1",
             .min = 0,
             .max = 50,
             .doc = "Sensor noise at mid grey, 8-bit grey levels, 1 sigma; grows with the root of "
                    "the light.",
             .source = "ours"}},
      Field{&T::jpeg_quality,
            {.key = "jpeg_quality",
             .unit = "1",
             .min = 30,
             .max = 100,
             .doc = "JPEG quality.",
             .source = "ours"}},
  };
};

/// The drone's way.
struct FlightOptions {
  bool enabled = true;
  double altitude_m = 65.0;
  double forward_overlap = 0.75;
  double side_overlap = 0.72;
  int oblique_photos = 14;
  double oblique_altitude_m = 55.0;
  double oblique_tilt_deg = 45.0;
  double position_sd_m = 0.5;
  double attitude_sd_deg = 1.2;
  double speed_mps = 6.0;
};
template <>
struct OptionFields<FlightOptions> {
  using T = FlightOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled, {.key = "enabled", .doc = "Make photos.", .source = "ours"}},
      Field{&T::altitude_m,
            {.key = "altitude_m",
             .unit = "m",
             .min = 20,
             .max = 500,
             .doc = "Height of the nadir grid above the ground.",
             .source = "HybridFusion IV-A"}},
      Field{&T::forward_overlap,
            {.key = "forward_overlap",
             .unit = "1",
             .min = 0.3,
             .max = 0.95,
             .doc = "Overlap of neighbours in a strip.",
             .source = "ours"}},
      Field{&T::side_overlap,
            {.key = "side_overlap",
             .unit = "1",
             .min = 0.2,
             .max = 0.95,
             .doc = "Overlap of neighbouring strips.",
             .source = "ours"}},
      Field{&T::oblique_photos,
            {.key = "oblique_photos",
             .unit = "1",
             .min = 0,
             .max = 500,
             .doc = "Photos of the oblique ring around each block.",
             .source = "ours"}},
      Field{&T::oblique_altitude_m,
            {.key = "oblique_altitude_m",
             .unit = "m",
             .min = 15,
             .max = 500,
             .doc = "Height of the oblique ring.",
             .source = "ours"}},
      Field{&T::oblique_tilt_deg,
            {.key = "oblique_tilt_deg",
             .unit = "deg",
             .min = 10,
             .max = 80,
             .doc = "Angle of the oblique views from straight down.",
             .source = "ours"}},
      Field{&T::position_sd_m,
            {.key = "position_sd_m",
             .unit = "m",
             .min = 0,
             .max = 10,
             .doc = "How far the drone is off the plan, 1 sigma.",
             .source = "ours"}},
      Field{&T::attitude_sd_deg,
            {.key = "attitude_sd_deg",
             .unit = "deg",
             .min = 0,
             .max = 20,
             .doc = "Error of the camera mount per axis, 1 sigma.",
             .source = "ours"}},
      Field{&T::speed_mps,
            {.key = "speed_mps",
             .unit = "m/s",
             .min = 1,
             .max = 30,
             .doc = "Ground speed, sets the photo times.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
