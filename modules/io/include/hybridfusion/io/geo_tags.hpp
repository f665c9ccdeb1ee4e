#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/photo.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Position of a photo that replaces the one in its metadata.
struct GeoTag {
  std::string photo = {};  ///< File name without folder.
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  std::optional<double> altitude_m = {};
  std::optional<double> sigma_horizontal_m = {};
  std::optional<double> sigma_vertical_m = {};
};

/// Reads positions of photos. Either the geo.txt of OpenDroneMap: a line with the coordinate system
/// (EPSG:n, "WGS84 UTM 32N" or a PROJ string), then `name x y [z [yaw pitch roll [sigma_h
/// [sigma_v]]]]`; or a table with commas and the columns name,lat,lon[,alt[,sigma_h[,sigma_v]]] in
/// degrees, with or without a heading.
/// @returns kNotFound, kParse naming the line, kInvalidOptions for an unknown coordinate system.
[[nodiscard]] Expected<std::vector<GeoTag>> read_geo_tags(const std::filesystem::path& path);

/// Replaces positions and their deviations; what the tags do not say is unknown afterwards.
/// @returns Number of photos that have a tag.
std::size_t apply_geo_tags(std::span<const GeoTag> tags, std::span<Photo> photos);

/// A surveyed point marked in photos.
struct SurveyedPoint {
  struct Mark {
    std::string photo = {};                           ///< File name without folder.
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< First pixel's centre at (0, 0).
  };
  std::string name = {};
  GeodeticPosition position = {};
  std::vector<Mark> marks = {};
};

/// Reads the gcp_list.txt of OpenDroneMap: a line with the coordinate system, then `x y z pixel_x
/// pixel_y photo [name]`, pixels counted from the corner of the photo. Lines with one name, or
/// without a name at one place, are marks of one point.
/// @returns as read_geo_tags.
[[nodiscard]] Expected<std::vector<SurveyedPoint>> read_surveyed_points(
    const std::filesystem::path& path);

}  // namespace hybridfusion
