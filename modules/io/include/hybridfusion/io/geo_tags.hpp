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
  std::string photo = {};  ///< Name of its file as written, perhaps with folders in front.
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  std::optional<double> altitude_m = {};
  std::optional<double> sigma_horizontal_m = {};
  std::optional<double> sigma_vertical_m = {};
  Eigen::Vector3d written = Eigen::Vector3d::Zero();  ///< As the row says, in units of the system.
};

struct GeoTagFile {
  std::string system = {};  ///< Of the first line; "EPSG:4326" for a table in degrees without one.
  std::vector<GeoTag> tags = {};
  std::vector<std::string> notes = {};  ///< What was taken for granted, for a person.
};

/// Reads positions of photos. Either the geo.txt of OpenDroneMap: a line with the coordinate system
/// (EPSG:n, "WGS84 UTM 32N" or a PROJ string), then `name x y [z [yaw pitch roll [sigma_h
/// [sigma_v]]]]`; or a table in degrees with commas, name,lat,lon[,alt[,sigma_h[,sigma_v]]] or in
/// the order of its heading. Columns between blanks, tabs, commas or semicolons; names with blanks
/// in quotes, between tabs or commas, or up to the extension of an image.
/// @returns kNotFound; kParse naming the line, for an unknown coordinate system, and for
/// coordinates that cannot be of their system (degrees as metres, axes swapped).
[[nodiscard]] Expected<GeoTagFile> read_geo_tags(const std::filesystem::path& path);

struct TaggedPhotos {
  std::size_t num_tagged = 0;
  std::vector<std::string> unknown = {};  ///< Names of tags that are no photo's.
};

/// Replaces positions and their deviations; what the tags do not say is unknown afterwards. Names
/// are matched as PhotoNames does.
TaggedPhotos apply_geo_tags(std::span<const GeoTag> tags, std::span<Photo> photos);

/// A surveyed point marked in photos.
struct SurveyedPoint {
  struct Mark {
    std::string photo = {};                           ///< As GeoTag::photo.
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< First pixel's centre at (0, 0).
  };
  std::string name = {};
  GeodeticPosition position = {};
  std::vector<Mark> marks = {};
  Eigen::Vector3d written = Eigen::Vector3d::Zero();  ///< As the row says, in units of the system.
};

struct SurveyFile {
  std::string system = {};              ///< Of the first line.
  double metres_per_height_unit = 1.0;  ///< By which the heights were multiplied.
  std::vector<SurveyedPoint> points = {};
  std::vector<std::string> notes = {};  ///< What was taken for granted, for a person.
};

/// Reads the gcp_list.txt of OpenDroneMap: a line with the coordinate system, then `x y z pixel_x
/// pixel_y photo [name]`, pixels counted from the corner of the photo. Lines with one name, or
/// without a name at one place, are marks of one point. Columns as in read_geo_tags.
/// @returns as read_geo_tags.
[[nodiscard]] Expected<SurveyFile> read_surveyed_points(const std::filesystem::path& path);

}  // namespace hybridfusion
