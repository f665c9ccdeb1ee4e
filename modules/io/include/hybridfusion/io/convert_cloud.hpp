#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/cloud_writer.hpp>
#include <hybridfusion/io/placed_cloud.hpp>
#include <hybridfusion/io/surface_raster.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// What is to become of a cloud file.
struct CloudConversion {
  std::filesystem::path in = {};
  std::optional<std::filesystem::path> out = {};    ///< The cloud in another format.
  std::optional<std::filesystem::path> dsm = {};    ///< GeoTIFF of the surface height.
  std::optional<std::filesystem::path> ortho = {};  ///< GeoTIFF of the colours.
  CloudFormat format = {};
  std::vector<std::string> columns = {};  ///< Names of the columns of a text cloud.
  SurfaceRasterOptions raster = {};
  std::optional<Georeference> georeference = {};  ///< Of a cloud in metres east, north, up.
  /// The georeference is a mere guess: a cloud in a coordinate system already stays there.
  bool keep_placed = false;
};

struct ConvertedCloud {
  std::uint64_t num_points = 0;
  CrsDescription crs = {};
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
  bool keeps_offset = true;  ///< Whether the coordinates in `out` have the offset in them.
  std::vector<std::string> warnings = {};
};

/// Reads the cloud batch by batch, twice (and once more for the rasters), so that memory does not
/// depend on its size: some 10 MB, and 15 bytes for each cell of a raster; 64 MiB more for a
/// compressed .pcd.
/// @returns errors of the reader and the writers; kInvalidOptions for a georeference of a cloud
/// that is in a coordinate system already; kCancelled. Nothing is written then.
[[nodiscard]] Expected<ConvertedCloud> convert_cloud(const CloudConversion& conversion,
                                                     const RunContext& ctx = {});

}  // namespace hybridfusion
