#include "crs.hpp"

#include <hybridfusion/io/las.hpp>

#include <cmath>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace hybridfusion {

struct EnuToProjected::State {
  GeodeticOrigin origin = {};
  OGRSpatialReference geographic;
  OGRSpatialReference projected;
  std::unique_ptr<OGRCoordinateTransformation> transformation = {};
  std::string wkt = {};
};

EnuToProjected::EnuToProjected(std::unique_ptr<State> state) : state_(std::move(state)) {}
EnuToProjected::EnuToProjected(EnuToProjected&&) noexcept = default;
EnuToProjected& EnuToProjected::operator=(EnuToProjected&&) noexcept = default;
EnuToProjected::~EnuToProjected() = default;

Expected<EnuToProjected> EnuToProjected::create(const GeodeticOrigin& origin, int epsg) {
  constexpr int kWgs84 = 4326;
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);  // GDAL would write to stderr
  auto state = std::make_unique<State>();
  state->origin = origin;
  if (state->geographic.importFromEPSG(kWgs84) != OGRERR_NONE ||
      state->projected.importFromEPSG(epsg) != OGRERR_NONE) {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("PROJ does not know EPSG:{}; install its database (proj-data)", epsg));
  }
  state->geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  state->projected.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  state->transformation.reset(
      OGRCreateCoordinateTransformation(&state->geographic, &state->projected));
  char* text = nullptr;
  const bool has_wkt = state->projected.exportToWkt(&text) == OGRERR_NONE && text != nullptr;
  if (has_wkt) state->wkt = text;
  CPLFree(text);
  if (!state->transformation || !has_wkt) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("PROJ cannot convert to EPSG:{}; install its database (proj-data)", epsg));
  }
  return EnuToProjected(std::move(state));
}

Expected<Eigen::Vector3d> EnuToProjected::operator()(const Eigen::Vector3d& point_in_enu) const {
  const GeodeticPosition position = geodetic_from_enu(state_->origin, point_in_enu);
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  double x = position.longitude_deg;
  double y = position.latitude_deg;
  if (state_->transformation->Transform(1, &x, &y) == 0 || !std::isfinite(x) || !std::isfinite(y)) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("({:.7f}, {:.7f}) deg cannot be projected; check the origin of the cloud",
                    position.latitude_deg,
                    position.longitude_deg));
  }
  return Eigen::Vector3d(x, y, position.altitude_m);
}

const std::string& EnuToProjected::wkt() const {
  return state_->wkt;
}

Expected<int> utm_epsg(const GeodeticPosition& position) {
  const double latitude = position.latitude_deg;
  if (!(latitude >= -80.0 && latitude <= 84.0) || !(std::abs(position.longitude_deg) <= 360.0)) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("latitude {} deg, longitude {} deg lie in no UTM zone (80 S .. 84 N)",
                            latitude,
                            position.longitude_deg));
  }
  const double longitude =
      position.longitude_deg - 360.0 * std::floor((position.longitude_deg + 180.0) / 360.0);
  int zone = static_cast<int>(std::floor((longitude + 180.0) / 6.0)) + 1;
  // Zone 32 is widened over south-west Norway, and Svalbard uses the odd zones only.
  if (latitude >= 56.0 && latitude < 64.0 && longitude >= 3.0 && longitude < 12.0) zone = 32;
  if (latitude >= 72.0 && longitude >= 0.0 && longitude < 42.0) {
    zone = longitude < 9.0 ? 31 : longitude < 21.0 ? 33 : longitude < 33.0 ? 35 : 37;
  }
  return (latitude >= 0.0 ? 32600 : 32700) + zone;
}

}  // namespace hybridfusion
