#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/io/las.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// Converts east-north-up coordinates at an origin to a projected system. Heights are ellipsoidal
/// (WGS84) unless the system has a vertical part.
class EnuToProjected {
 public:
  /// @param crs  "EPSG:n" or "EPSG:n+m"; empty: the UTM zone of the origin.
  /// @returns kInvalidOptions for a system that PROJ does not know, that is not projected in metres
  /// or whose heights need a geoid model that is not installed; kDegenerate for an origin outside
  /// the UTM zones.
  [[nodiscard]] static Expected<EnuToProjected> create(const GeodeticOrigin& origin,
                                                       const std::string& crs);

  EnuToProjected(EnuToProjected&&) noexcept;
  EnuToProjected& operator=(EnuToProjected&&) noexcept;
  ~EnuToProjected();

  /// Easting, northing, height [m]. @returns kDegenerate where the projection fails.
  [[nodiscard]] Expected<Eigen::Vector3d> operator()(const Eigen::Vector3d& point_in_enu) const;
  /// WKT 1 of the projected system, as LAS wants it.
  [[nodiscard]] const std::string& wkt() const;

 private:
  struct State;
  explicit EnuToProjected(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Converts coordinates of a system to WGS84. Heights stay as they are unless the system has a
/// vertical part.
class ProjectedToGeodetic {
 public:
  /// @param system  "EPSG:n", "EPSG:n+m", "WGS84 UTM 32N" or a PROJ string "+proj=...".
  /// @returns kInvalidOptions for a system that PROJ does not know.
  [[nodiscard]] static Expected<ProjectedToGeodetic> create(const std::string& system);

  ProjectedToGeodetic(ProjectedToGeodetic&&) noexcept;
  ProjectedToGeodetic& operator=(ProjectedToGeodetic&&) noexcept;
  ~ProjectedToGeodetic();

  /// @param point  Easting or longitude, northing or latitude, height.
  /// @returns kDegenerate where the system does not reach.
  [[nodiscard]] Expected<GeodeticPosition> operator()(const Eigen::Vector3d& point) const;

 private:
  struct State;
  explicit ProjectedToGeodetic(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// What a WKT of either version says; only the name is filled when it cannot be interpreted.
[[nodiscard]] CrsDescription describe_crs(const std::string& wkt);
/// EPSG codes of the horizontal and, of a compound system, the vertical part; 0: none.
struct EpsgCodes {
  int horizontal = 0;
  int vertical = 0;
};
[[nodiscard]] EpsgCodes epsg_codes(const std::string& wkt);
/// The system of an EPSG code; nothing when PROJ does not know it.
[[nodiscard]] std::optional<CrsDescription> describe_crs(int epsg);

}  // namespace hybridfusion
