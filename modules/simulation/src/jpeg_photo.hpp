#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/time.hpp>

#include <string>

namespace hybridfusion {

/// What the camera writes about a photo.
struct ExifFields {
  Timestamp time{};
  double focal_mm = 0.0;
  double focal_35mm = 0.0;
  int width_px = 0;
  int height_px = 0;
  GeodeticPosition position = {};
  double horizontal_error_m = 0.0;
};

/// Content of an APP1 segment: "Exif\0\0" and a little-endian TIFF with IFD0, Exif and GPS
/// directories (CIPA DC-008).
[[nodiscard]] std::string exif_segment(const ExifFields& fields);

/// JPEG (4:2:0 as cameras write it) in memory. @param exif  Empty: none.
[[nodiscard]] Expected<std::string> encode_jpeg(const Image8& image,
                                                int quality,
                                                const std::string& exif);

}  // namespace hybridfusion
