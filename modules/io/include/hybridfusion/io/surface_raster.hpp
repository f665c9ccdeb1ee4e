#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <filesystem>
#include <limits>
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
  double metres_per_unit = 1.0;           ///< Of the system; the file counts as it does.
  double vertical_metres_per_unit = 1.0;  ///< The heights of the file too.
};

struct SurfaceRasterOptions {
  double cell_m = 0.25;  ///< @pre > 0
  int fill_cells = 3;    ///< Gaps this deep are closed by the mean of the neighbours; 0: none.
};

/// The ground that a cloud covers. Cloud by cloud, all with the same offset.
struct SurfaceExtent {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;

  void add(const PointCloud& cloud, const Eigen::Vector3d& offset_m);
};

/// Draws clouds that lie within an extent, one after the other.
class SurfaceRasterBuilder {
 public:
  /// @returns kInsufficient for an extent without points, kInvalidOptions when the cells would be
  /// more than 100 million.
  [[nodiscard]] static Expected<SurfaceRasterBuilder> create(const SurfaceExtent& extent,
                                                             const SurfaceRasterOptions& options);
  /// @pre the extent holds the points; all clouds or none have colours.
  void add(const PointCloud& cloud, const Eigen::Vector3d& offset_m);
  [[nodiscard]] SurfaceRaster finish(const CrsDescription& crs) &&;

 private:
  explicit SurfaceRasterBuilder(const SurfaceRasterOptions& options) : options_(options) {}

  SurfaceRasterOptions options_;
  Eigen::Array2d first_ = Eigen::Array2d::Zero();  ///< Of the cells, counted from 0 of the CRS.
  Eigen::Array2d last_ = Eigen::Array2d::Zero();
  SurfaceRaster raster_ = {};
};

/// One cloud drawn. @returns as SurfaceRasterBuilder::create.
[[nodiscard]] Expected<SurfaceRaster> make_surface_raster(const PlacedCloud& placed,
                                                          const SurfaceRasterOptions& options = {});

/// Heights as a GeoTIFF of one float32 band in the unit of the heights of the system (metres when
/// it has none), "no data" -9999.
[[nodiscard]] Expected<void> write_dsm(const std::filesystem::path& path,
                                       const SurfaceRaster& raster);

/// Colours as a GeoTIFF of red, green, blue and alpha (0 where nothing was seen).
/// @returns kInsufficient when the cloud had no colours.
[[nodiscard]] Expected<void> write_orthophoto(const std::filesystem::path& path,
                                              const SurfaceRaster& raster);

}  // namespace hybridfusion
