#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

using LasGeoreference = Georeference;

/// Reads LAS 1.0 to 1.4, point formats 0 to 10 (the waveforms of 4, 5, 9 and 10 are passed over),
/// in metres whatever the unit of the file. Coordinates of 10 km and more are taken relative to an
/// offset of whole kilometres. Intensity, colour, GPS time (when absolute) and the extra byte
/// `source` fill the channels; withheld points are left out.
/// @returns kNotFound; kParse naming the file, the cause and the next step, also for LAZ and for
/// coordinates in degrees.
[[nodiscard]] Expected<PlacedCloud> read_las(const std::filesystem::path& path);

/// Minor version of LAS 1.
enum class LasVersion : std::uint8_t { k12 = 2, k13 = 3, k14 = 4 };

struct LasWriteOptions {
  std::optional<LasGeoreference> georeference = {};    ///< Absent: no change of coordinates.
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< Added; not with a georeference.
  std::string wkt = {};  ///< CRS of the coordinates with the offset; not with a georeference.
  LasVersion version = LasVersion::k14;
};

/// Writes LAS 1.4, point format 7 (GPS time and RGB) or, without colours, 6, or LAS 1.2 and 1.3,
/// formats 3 and 1, in millimetre steps, with a `source` extra byte (0 vision, 1 LiDAR) when the
/// cloud has sources. With a georeference, coordinates become those of the CRS (by default the UTM
/// zone of the origin on WGS84, with ellipsoidal heights) and the file carries its WKT; LAS 1.2 and
/// 1.3 also its EPSG codes as GeoTIFF keys, which is all that their readers know.
/// @returns kInsufficient for an empty cloud, kDegenerate for an origin outside the UTM zones, kIo.
[[nodiscard]] Expected<void> write_las(const std::filesystem::path& path,
                                       const PointCloud& cloud,
                                       const LasWriteOptions& options = {});

/// EPSG code of the UTM zone (WGS84) that contains the position: 326zz north, 327zz south, with the
/// exceptions for south-west Norway and Svalbard.
/// @returns kDegenerate beyond 80 S .. 84 N or for a position that is not finite.
[[nodiscard]] Expected<int> utm_epsg(const GeodeticPosition& position);

}  // namespace hybridfusion
