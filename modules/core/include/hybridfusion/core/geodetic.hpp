#pragma once

#include <Eigen/Core>

namespace hybridfusion {

/// WGS84 position; height above the ellipsoid.
struct GeodeticPosition {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_m = 0.0;
};

/// Where the east-north-up plane touches the ellipsoid.
using GeodeticOrigin = GeodeticPosition;

/// East, north, up [m] in the plane at `origin`.
[[nodiscard]] Eigen::Vector3d enu_from_geodetic(const GeodeticOrigin& origin,
                                                const GeodeticPosition& position);
[[nodiscard]] GeodeticPosition geodetic_from_enu(const GeodeticOrigin& origin,
                                                 const Eigen::Vector3d& point_in_enu);

}  // namespace hybridfusion
