#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <filesystem>
#include <optional>

namespace hybridfusion {

/// Says where a local cloud lies: its coordinates are east, north, up at `origin`.
struct LasGeoreference {
  GeodeticOrigin origin = {};
};

struct LasWriteOptions {
  std::optional<LasGeoreference> georeference = {};  ///< Absent: local coordinates, no CRS.
};

/// Writes LAS 1.4, point format 7 (GPS time and RGB), millimetre steps, with a `source` extra byte
/// (0 vision, 1 LiDAR) when the cloud has sources. With a georeference, coordinates become those of
/// the UTM zone of the origin (WGS84, ellipsoidal height) and the file carries its WKT.
/// @returns kInsufficient for an empty cloud, kDegenerate for an origin outside the UTM zones, kIo.
[[nodiscard]] Expected<void> write_las(const std::filesystem::path& path,
                                       const PointCloud& cloud,
                                       const LasWriteOptions& options = {});

/// EPSG code of the UTM zone (WGS84) that contains the position: 326zz north, 327zz south, with the
/// exceptions for south-west Norway and Svalbard.
/// @returns kDegenerate beyond 80 S .. 84 N or for a position that is not finite.
[[nodiscard]] Expected<int> utm_epsg(const GeodeticPosition& position);

}  // namespace hybridfusion
