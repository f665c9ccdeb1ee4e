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
  /// @param allow_ballpark  Also with a transformation that is worse than judge_accuracy allows.
  /// @returns kInvalidOptions for a system that PROJ does not know, that is not projected or whose
  /// heights need a geoid model that is not installed; kDegenerate for an origin outside the UTM
  /// zones.
  [[nodiscard]] static Expected<EnuToProjected> create(const GeodeticOrigin& origin,
                                                       const std::string& crs,
                                                       bool allow_ballpark = false);

  EnuToProjected(EnuToProjected&&) noexcept;
  EnuToProjected& operator=(EnuToProjected&&) noexcept;
  ~EnuToProjected();

  /// Easting, northing, height in metres, whatever the system counts. @returns kDegenerate where
  /// the projection fails.
  [[nodiscard]] Expected<Eigen::Vector3d> operator()(const Eigen::Vector3d& point_in_enu) const;
  /// Metres in a unit of each axis of the system; of heights 1 when it has none.
  [[nodiscard]] const Eigen::Vector3d& units_m() const;
  [[nodiscard]] const std::string& warning() const;  ///< Empty: the transformation is good.
  /// WKT 1 of the projected system, as LAS wants it.
  [[nodiscard]] const std::string& wkt() const;

 private:
  struct State;
  explicit EnuToProjected(std::unique_ptr<State> state);
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
