#pragma once

#include <hybridfusion/core/geodetic.hpp>

#include <optional>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// A place as a table of positions states it.
struct StatedPlace {
  std::string system = {};                            ///< Of the table; empty: degrees, WGS84.
  Eigen::Vector3d written = Eigen::Vector3d::Zero();  ///< x y z of the row, in units of the system.
  GeodeticPosition position = {};                     ///< What the row means under the system.
};

/// The likely mistake behind a place that lies elsewhere than it should: the first of the usual
/// ones (axes swapped, a sign, another UTM zone, degrees under a projected system, feet) that takes
/// it to within `limit_m` of the reference, in words; empty when none does.
[[nodiscard]] std::string horizontal_cause(const StatedPlace& stated,
                                           const GeodeticPosition& reference,
                                           double limit_m);

/// The likely mistake behind a height: feet for metres or the reverse, a sign, or above sea level
/// against above the ellipsoid, where it explains the difference to within `limit_m`.
struct HeightCause {
  enum class Kind { kNone, kUnit, kSign, kSeaLevel } kind = Kind::kNone;
  std::string text = {};  ///< In words; empty for kNone.
};
[[nodiscard]] HeightCause height_cause(double stated_m,
                                       const GeodeticPosition& reference,
                                       double limit_m);

/// Height of the EGM96 geoid above the ellipsoid; nothing where its grid is not installed.
[[nodiscard]] std::optional<double> geoid_height_m(double latitude_deg, double longitude_deg);

/// Distance over ground [m], for any two places.
[[nodiscard]] double ground_distance_m(const GeodeticPosition& a, const GeodeticPosition& b);

}  // namespace hybridfusion
