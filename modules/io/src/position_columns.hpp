#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace hybridfusion {

/// Where a table of photo positions keeps what. The default is that of geo.txt: name x y z, three
/// angles, two deviations.
struct PositionColumns {
  std::size_t name = 0;
  std::size_t x = 1;  ///< Easting or longitude.
  std::size_t y = 2;  ///< Northing or latitude.
  std::optional<std::size_t> z = 3;
  std::optional<std::size_t> sigma_horizontal = 7;
  std::optional<std::size_t> sigma_vertical = 8;
  bool in_degrees = false;  ///< The columns are called latitude and longitude.
};

/// The columns that a heading names, in the words of exiftool, Metashape
/// ("#Label,X/Longitude,..."), Pix4D and RealityCapture; nothing when it does not name photo and
/// both coordinates.
[[nodiscard]] std::optional<PositionColumns> columns_of_heading(std::string_view line);

}  // namespace hybridfusion
