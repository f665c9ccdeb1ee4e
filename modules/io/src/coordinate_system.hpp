#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace hybridfusion {

/// The coordinate system of a table of positions, and the way from it to WGS84. Heights stay as
/// they are unless the system has a vertical part; without one they count in the unit of its
/// plane, because a surveyor who works in feet levels in feet.
class CoordinateSystem {
 public:
  /// @param text  "EPSG:n", "EPSG:n+m" (any case), "WGS84 UTM 32N" and its other spellings, a PROJ
  /// string with +proj=..., or a WKT in one line.
  /// @returns kParse for a system that PROJ does not know, or whose heights need a geoid model that
  /// is not installed.
  [[nodiscard]] static Expected<CoordinateSystem> create(std::string_view text);

  CoordinateSystem(CoordinateSystem&&) noexcept;
  CoordinateSystem& operator=(CoordinateSystem&&) noexcept;
  ~CoordinateSystem();

  /// @param point  Easting or longitude, northing or latitude, height; in units of the system.
  /// @returns kDegenerate where the system does not reach.
  [[nodiscard]] Expected<GeodeticPosition> operator()(const Eigen::Vector3d& point) const;

  [[nodiscard]] const std::string& text() const;  ///< As it was given, without blanks around.
  [[nodiscard]] bool is_geographic() const;
  /// Metres in a unit of a height; 1 where the system has a vertical part, which is converted.
  [[nodiscard]] double metres_per_height_unit() const;
  [[nodiscard]] const std::string& unit_name() const;  ///< Of the plane: "US survey foot".
  /// Whether the place lies in the area that the system is made for, with a margin of 3 degrees, as
  /// for blocks at the edge of a zone; true where the area is not known.
  [[nodiscard]] bool covers(const GeodeticPosition& position) const;

 private:
  struct State;
  explicit CoordinateSystem(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Whether a line reads like the name of a coordinate system, known or not.
[[nodiscard]] bool names_coordinate_system(std::string_view line);

}  // namespace hybridfusion
