#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/time.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Interleaved 8-bit image, rows from the top, no padding: pixels[(y * width + x) * channels + c].
struct Image8 {
  int width = 0;
  int height = 0;
  int channels = 0;  ///< 1 grey, 3 RGB.
  std::vector<std::uint8_t> pixels = {};
};

/// Angles of the camera mount as DJI writes them: yaw clockwise from north, pitch -90 looks down.
struct GimbalAngles {
  double yaw_deg = 0.0;
  double pitch_deg = 0.0;
  double roll_deg = 0.0;
};

/// What a photo says of itself (EXIF and XMP). Absent values are empty, never zero.
struct PhotoMetadata {
  std::string name = {};  ///< File name without folder.
  int width = 0;          ///< Of the pixels as stored [px].
  int height = 0;
  std::string make = {};
  std::string model = {};
  std::string serial = {};
  std::optional<double> focal_mm = {};
  std::optional<double> focal_35mm = {};             ///< 35 mm equivalent [mm].
  std::optional<double> focal_plane_px_per_mm = {};  ///< As written, for the original image width.
  std::optional<int> original_width = {};            ///< PixelXDimension when it is present.
  std::optional<Timestamp> time = {};
  std::optional<double> latitude_deg = {};
  std::optional<double> longitude_deg = {};
  std::optional<double> altitude_m = {};           ///< EXIF GPSAltitude with AltitudeRef applied.
  std::optional<double> absolute_altitude_m = {};  ///< XMP drone-dji:AbsoluteAltitude.
  std::optional<double> relative_altitude_m =
      {};  ///< XMP drone-dji:RelativeAltitude (above take-off).
  std::optional<double> gps_horizontal_error_m = {};  ///< GPSHPositioningError.
  std::optional<double> gps_dop = {};
  std::optional<Eigen::Vector3d> rtk_sigma_enu_m = {};
  std::optional<GimbalAngles> gimbal = {};
  std::optional<double> calibrated_focal_px = {};  ///< XMP factory calibration (DewarpData).
};

/// A photo whose pixels are decoded on demand (they do not all fit in memory).
struct Photo {
  PhotoMetadata metadata = {};
  std::function<Expected<Image8>()> load = {};  ///< RGB, thread-safe.
};

}  // namespace hybridfusion
