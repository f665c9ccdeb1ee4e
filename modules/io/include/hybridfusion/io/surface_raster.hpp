#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// A cloud seen from above: for each cell its highest point. Row by row from the north.
struct SurfaceRaster {
  int columns = 0;
  int rows = 0;
  double cell_m = 0.0;
  Eigen::Vector2d north_west =
      Eigen::Vector2d::Zero();        ///< Outer corner of the first cell, in crs.
  std::vector<float> heights_m = {};  ///< NaN where nothing was seen.
  std::vector<Rgb8> colors = {};      ///< Empty when the cloud has none.
  std::string wkt = {};
};

struct SurfaceRasterOptions {
  double cell_m = 0.25;  ///< @pre > 0
  int fill_cells = 3;    ///< Gaps this deep are closed by the mean of the neighbours; 0: none.
};

/// @returns kInsufficient for an empty cloud, kInvalidOptions when the cells would be more than 100
/// million.
[[nodiscard]] Expected<SurfaceRaster> make_surface_raster(const PlacedCloud& placed,
                                                          const SurfaceRasterOptions& options = {});

/// Heights as a GeoTIFF of one float32 band [m], "no data" -9999.
[[nodiscard]] Expected<void> write_dsm(const std::filesystem::path& path,
                                       const SurfaceRaster& raster);

/// Colours as a GeoTIFF of red, green, blue and alpha (0 where nothing was seen).
/// @returns kInsufficient when the cloud had no colours.
[[nodiscard]] Expected<void> write_orthophoto(const std::filesystem::path& path,
                                              const SurfaceRaster& raster);

}  // namespace hybridfusion
