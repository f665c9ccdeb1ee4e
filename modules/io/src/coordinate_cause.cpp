#include "coordinate_system.hpp"
#include "text.hpp"

#include <hybridfusion/io/coordinate_cause.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

constexpr double kFoot_m = 0.3048;  // the survey foot differs by 2e-6 of it

bool on_earth(double latitude_deg, double longitude_deg) {
  return std::abs(latitude_deg) <= 90.0 && std::abs(longitude_deg) <= 180.0;
}

bool near(double latitude_deg,
          double longitude_deg,
          const GeodeticPosition& reference,
          double limit_m) {
  return on_earth(latitude_deg, longitude_deg) &&
         ground_distance_m({.latitude_deg = latitude_deg, .longitude_deg = longitude_deg},
                           reference) <= limit_m;
}

/// Whether x and y, read under that system, lie at the reference.
bool fits(const std::string& system,
          const Eigen::Vector3d& written,
          const GeodeticPosition& reference,
          double limit_m) {
  const auto to_geodetic = CoordinateSystem::create(system);
  if (!to_geodetic) return false;
  const auto at = (*to_geodetic)(written);
  return at && near(at->latitude_deg, at->longitude_deg, reference, limit_m);
}

/// The zone of UTM in which the coordinates lie at the reference.
std::string other_zone(const Eigen::Vector3d& written,
                       const GeodeticPosition& reference,
                       double limit_m) {
  const int middle = static_cast<int>(std::floor((reference.longitude_deg + 180.0) / 6.0)) + 1;
  for (const int step : {0, -1, 1, -2, 2}) {
    const int zone = (middle + step + 59) % 60 + 1;
    for (const char half : {'N', 'S'}) {
      const std::string name = fmt::format("WGS84 UTM {}{}", zone, half);
      if (fits(name, written, reference, limit_m)) return fmt::format("{}{}", zone, half);
    }
  }
  return {};
}

}  // namespace

double ground_distance_m(const GeodeticPosition& a, const GeodeticPosition& b) {
  // A chord, not only east and north: beyond the horizon the plane leaves the Earth.
  return enu_from_geodetic({.latitude_deg = a.latitude_deg, .longitude_deg = a.longitude_deg},
                           {.latitude_deg = b.latitude_deg, .longitude_deg = b.longitude_deg})
      .norm();
}

std::string horizontal_cause(const StatedPlace& stated,
                             const GeodeticPosition& reference,
                             double limit_m) {
  const auto [latitude, longitude, altitude] = stated.position;
  const Eigen::Vector3d& written = stated.written;
  if (near(longitude, latitude, reference, limit_m)) {
    return "these look like latitude and longitude swapped";
  }
  if (near(latitude, -longitude, reference, limit_m)) {
    return "the sign of the longitude looks wrong (west is negative)";
  }
  if (near(-latitude, longitude, reference, limit_m)) {
    return "the sign of the latitude looks wrong (south is negative)";
  }
  if (stated.system.empty()) return {};
  const auto system = CoordinateSystem::create(stated.system);
  if (!system || system->is_geographic()) return {};
  if (near(written.y(), written.x(), reference, limit_m) ||
      near(written.x(), written.y(), reference, limit_m)) {
    return fmt::format("these look like degrees, not coordinates of {}", stated.system);
  }
  if (fits(stated.system, {written.y(), written.x(), 0.0}, reference, limit_m)) {
    return "these look like easting and northing swapped";
  }
  if (const std::string zone = other_zone(written, reference, limit_m); !zone.empty()) {
    return fmt::format("they fit UTM zone {}: the zone of {} looks wrong", zone, stated.system);
  }
  for (const double factor : {kFoot_m, 1.0 / kFoot_m}) {
    if (fits(stated.system, factor * written, reference, limit_m)) {
      return fmt::format("these look like {}, which is not the unit of {}",
                         factor < 1.0 ? "feet" : "metres",
                         stated.system);
    }
  }
  return {};
}

std::optional<double> geoid_height_m(double latitude_deg, double longitude_deg) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  OGRSpatialReference ellipsoidal;
  OGRSpatialReference above_sea;
  constexpr int kWgs84WithHeight = 4979;
  if (ellipsoidal.importFromEPSG(kWgs84WithHeight) != OGRERR_NONE ||
      above_sea.SetFromUserInput("EPSG:4326+5773") != OGRERR_NONE) {
    return std::nullopt;
  }
  ellipsoidal.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  above_sea.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationOptions options;
  options.SetBallparkAllowed(false);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&ellipsoidal, &above_sea, options));
  double x = longitude_deg;
  double y = latitude_deg;
  double z = 0.0;
  if (!transformation || transformation->Transform(1, &x, &y, &z) == 0 || !std::isfinite(z)) {
    return std::nullopt;
  }
  return -z;
}

HeightCause height_cause(double stated_m, const GeodeticPosition& reference, double limit_m) {
  using Kind = HeightCause::Kind;
  const auto explains = [&](double height_m) {
    return std::abs(height_m - reference.altitude_m) <= limit_m;
  };
  if (explains(stated_m)) return {};
  if (explains(kFoot_m * stated_m)) {
    return {.kind = Kind::kUnit, .text = "the heights look like feet taken for metres"};
  }
  if (explains(stated_m / kFoot_m)) {
    return {.kind = Kind::kUnit, .text = "the heights look like metres taken for feet"};
  }
  if (const auto geoid_m = geoid_height_m(reference.latitude_deg, reference.longitude_deg)) {
    for (const double sign : {1.0, -1.0}) {
      if (std::abs(*geoid_m) <= limit_m || !explains(stated_m + sign * *geoid_m)) continue;
      return {.kind = Kind::kSeaLevel,
              .text = fmt::format("the geoid lies {:.1f} m {} the ellipsoid there: one of the two "
                                  "looks like a height above sea level, the other above the "
                                  "ellipsoid",
                                  std::abs(*geoid_m),
                                  *geoid_m > 0.0 ? "above" : "below")};
    }
  }
  if (explains(-stated_m)) {
    return {.kind = Kind::kSign, .text = "the sign of one of the two looks wrong (GPSAltitudeRef)"};
  }
  return {};
}

}  // namespace hybridfusion
