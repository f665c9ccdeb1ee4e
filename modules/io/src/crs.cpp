#include "crs.hpp"

#include "cloud_builder.hpp"
#include "crs_accuracy.hpp"
#include "crs_units.hpp"
#include "text.hpp"

#include <cmath>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

[[nodiscard]] CrsDescription describe(const OGRSpatialReference& system) {
  CrsDescription crs;
  const char* const name = system.GetName();
  crs.name = name == nullptr ? "" : name;
  crs.geographic = system.IsGeographic() != 0;
  char* text = nullptr;
  if (system.exportToWkt(&text) == OGRERR_NONE && text != nullptr) crs.wkt = text;
  CPLFree(text);
  if (crs.geographic) return crs;
  if (const auto units = axis_units(crs.wkt)) {
    crs.metres_per_unit = units->horizontal_m;
    crs.vertical_metres_per_unit = units->vertical_m.value_or(units->horizontal_m);
  }
  return crs;
}

}  // namespace

CrsDescription describe_crs(const std::string& wkt) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  OGRSpatialReference system;
  if (system.importFromWkt(wkt.c_str()) != OGRERR_NONE) return {.name = "unknown", .wkt = wkt};
  CrsDescription crs = describe(system);
  crs.wkt = wkt;
  return crs;
}

EpsgCodes epsg_codes(const std::string& wkt) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  OGRSpatialReference system;
  if (system.importFromWkt(wkt.c_str()) != OGRERR_NONE) return {};
  const auto code_of = [&](const char* node) {
    const char* name = system.GetAuthorityName(node);
    const char* code = system.GetAuthorityCode(node);
    return name != nullptr && code != nullptr && std::string_view(name) == "EPSG" ? std::atoi(code)
                                                                                  : 0;
  };
  return {.horizontal = code_of("PROJCS"), .vertical = code_of("VERT_CS")};
}

std::optional<CrsDescription> describe_crs(int epsg) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  OGRSpatialReference system;
  if (system.importFromEPSG(epsg) != OGRERR_NONE) return std::nullopt;
  return describe(system);
}

struct EnuToProjected::State {
  GeodeticOrigin origin = {};
  OGRSpatialReference geographic;
  OGRSpatialReference projected;
  std::unique_ptr<OGRCoordinateTransformation> transformation = {};
  std::string wkt = {};
  Eigen::Vector3d units_m = Eigen::Vector3d::Ones();
  std::string warning = {};
};

EnuToProjected::EnuToProjected(std::unique_ptr<State> state) : state_(std::move(state)) {}
EnuToProjected::EnuToProjected(EnuToProjected&&) noexcept = default;
EnuToProjected& EnuToProjected::operator=(EnuToProjected&&) noexcept = default;
EnuToProjected::~EnuToProjected() = default;

Expected<EnuToProjected> EnuToProjected::create(const GeodeticOrigin& origin,
                                                const std::string& crs,
                                                bool allow_ballpark) {
  std::string wanted = crs;
  if (lower_case(wanted).starts_with("epsg:")) wanted.replace(0, 5, "EPSG:");
  if (wanted.empty()) {
    HF_TRY(const int epsg, utm_epsg(origin));
    wanted = fmt::format("EPSG:{}", epsg);
  }
  const auto refuse = [&wanted](const std::string& cause) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format(
            "{}: {}; give EPSG:n or EPSG:n+m of a projected system", printable(wanted), cause));
  };
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);  // GDAL would write to stderr
  auto state = std::make_unique<State>();
  state->origin = origin;
  // Only codes: SetFromUserInput would also open files and fetch addresses.
  const bool is_code = wanted.starts_with("EPSG:") &&
                       wanted.find_first_not_of("0123456789+", 5) == std::string::npos;
  if (!is_code) return refuse("not an EPSG code");
  if (state->projected.SetFromUserInput(wanted.c_str()) != OGRERR_NONE) {
    return refuse("PROJ does not know it (is its database, proj-data, installed?)");
  }
  if (state->projected.IsProjected() == 0) return refuse("not a projected system");
  constexpr int kWgs84WithHeight = 4979;
  constexpr int kWgs84 = 4326;
  const bool vertical = state->projected.IsVertical() != 0;
  if (state->geographic.importFromEPSG(vertical ? kWgs84WithHeight : kWgs84) != OGRERR_NONE) {
    return refuse("the database of PROJ is missing");
  }
  state->geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  state->projected.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationOptions options;
  // A "ballpark" transformation would leave ellipsoidal heights as they are, off by the geoid.
  options.SetBallparkAllowed(false);
  state->transformation.reset(
      OGRCreateCoordinateTransformation(&state->geographic, &state->projected, options));
  char* text = nullptr;
  const bool has_wkt = state->projected.exportToWkt(&text) == OGRERR_NONE && text != nullptr;
  if (has_wkt) state->wkt = text;
  CPLFree(text);
  if (!state->transformation || !has_wkt) {
    const std::string grids = vertical ? missing_grids(origin, wanted) : "";
    return refuse(grids.empty() ? "PROJ cannot convert to it"
                                : "its heights need a geoid model that is not installed" + grids);
  }
  // Without a vertical part heights stay ellipsoidal, in metres.
  if (const auto units = axis_units(state->wkt)) {
    state->units_m = {
        units->horizontal_m, units->horizontal_m, vertical ? units->vertical_m.value_or(1.0) : 1.0};
  }
  HF_TRY(state->warning, judge_accuracy(origin, wanted, allow_ballpark));
  EnuToProjected result(std::move(state));
  if (auto probe = result(Eigen::Vector3d::Zero()); !probe) {
    return refuse(vertical ? "its heights need a geoid model that is not installed" +
                                 missing_grids(origin, wanted)
                           : "it does not cover the place of the cloud");
  }
  return result;
}

Expected<Eigen::Vector3d> EnuToProjected::operator()(const Eigen::Vector3d& point_in_enu) const {
  const GeodeticPosition position = geodetic_from_enu(state_->origin, point_in_enu);
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  Eigen::Vector3d at(position.longitude_deg, position.latitude_deg, position.altitude_m);
  if (state_->transformation->Transform(1, &at.x(), &at.y(), &at.z()) == 0 || !at.allFinite()) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("({:.7f}, {:.7f}) deg cannot be projected; check the origin of the cloud",
                    position.latitude_deg,
                    position.longitude_deg));
  }
  return Eigen::Vector3d(at.cwiseProduct(state_->units_m));
}

const Eigen::Vector3d& EnuToProjected::units_m() const {
  return state_->units_m;
}

const std::string& EnuToProjected::warning() const {
  return state_->warning;
}

struct CloudProjector::State {
  EnuToProjected projection;
  Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();
  CrsDescription crs = {};
};

CloudProjector::CloudProjector(std::unique_ptr<State> state) : state_(std::move(state)) {}
CloudProjector::CloudProjector(CloudProjector&&) noexcept = default;
CloudProjector& CloudProjector::operator=(CloudProjector&&) noexcept = default;
CloudProjector::~CloudProjector() = default;

Expected<CloudProjector> CloudProjector::create(const Georeference& georeference) {
  HF_TRY(
      EnuToProjected projection,
      EnuToProjected::create(georeference.origin, georeference.crs, georeference.allow_ballpark));
  HF_TRY(const Eigen::Vector3d origin, projection(Eigen::Vector3d::Zero()));
  CrsDescription crs = describe_crs(projection.wkt());
  crs.vertical_metres_per_unit = projection.units_m().z();
  return CloudProjector(std::make_unique<State>(State{.projection = std::move(projection),
                                                      .offset_m = whole_kilometres(origin),
                                                      .crs = std::move(crs)}));
}

Expected<PointCloud> CloudProjector::operator()(PointCloud cloud) const {
  for (Eigen::Vector3f& point : cloud.points) {
    HF_TRY(const Eigen::Vector3d at, state_->projection(point.cast<double>()));
    point = (at - state_->offset_m).cast<float>();
  }
  cloud.normals.clear();
  return cloud;
}

const Eigen::Vector3d& CloudProjector::offset_m() const {
  return state_->offset_m;
}

const std::string& CloudProjector::warning() const {
  return state_->projection.warning();
}

const CrsDescription& CloudProjector::crs() const {
  return state_->crs;
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
