#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/placed_cloud.hpp>

#include <filesystem>
#include <optional>

namespace hybridfusion {

/// Reads a cloud by its extension: .ply, .pcd, .las, or text (.xyz .txt .csv .asc .pts).
/// @returns kInvalidOptions for another extension, naming those that are read.
[[nodiscard]] Expected<PointCloud> read_point_cloud(const std::filesystem::path& path);

/// As read_point_cloud, for coordinates of any size: an offset is taken off large ones.
[[nodiscard]] Expected<PlacedCloud> read_placed_cloud(const std::filesystem::path& path);

/// Writes by extension: .ply, .pcd, .xyz or .las.
/// @param origin  ENU origin of the cloud; used where the format can say it (.las).
[[nodiscard]] Expected<void> write_point_cloud(const std::filesystem::path& path,
                                               const PointCloud& cloud,
                                               const std::optional<GeodeticOrigin>& origin = {});

/// Writes by extension. .las and .xyz get the coordinates with the offset (and .las the CRS, when
/// it is metric), .ply and .pcd those without.
/// @returns true when the file has the offset in it, or there is none.
[[nodiscard]] Expected<bool> write_placed_cloud(const std::filesystem::path& path,
                                                const PlacedCloud& placed);

}  // namespace hybridfusion
