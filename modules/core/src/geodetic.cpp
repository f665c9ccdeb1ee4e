#include <hybridfusion/core/geodetic.hpp>

#include <GeographicLib/LocalCartesian.hpp>

namespace hybridfusion {
namespace {

GeographicLib::LocalCartesian plane_at(const GeodeticOrigin& origin) {
  return {origin.latitude_deg, origin.longitude_deg, origin.altitude_m};
}

}  // namespace

Eigen::Vector3d enu_from_geodetic(const GeodeticOrigin& origin, const GeodeticPosition& position) {
  Eigen::Vector3d enu;
  plane_at(origin).Forward(position.latitude_deg,
                           position.longitude_deg,
                           position.altitude_m,
                           enu.x(),
                           enu.y(),
                           enu.z());
  return enu;
}

GeodeticPosition geodetic_from_enu(const GeodeticOrigin& origin,
                                   const Eigen::Vector3d& point_in_enu) {
  GeodeticPosition position;
  plane_at(origin).Reverse(point_in_enu.x(),
                           point_in_enu.y(),
                           point_in_enu.z(),
                           position.latitude_deg,
                           position.longitude_deg,
                           position.altitude_m);
  return position;
}

}  // namespace hybridfusion
