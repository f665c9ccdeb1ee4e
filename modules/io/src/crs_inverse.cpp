#include "crs.hpp"
#include "text.hpp"

#include <cmath>

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

/// EPSG code of "WGS84 UTM 32N"; nothing for another text.
std::optional<int> utm_code(const std::string& system) {
  const std::vector<std::string_view> words = split_words(system);
  if (words.size() != 3 || lower_case(words[0]) != "wgs84" || lower_case(words[1]) != "utm") {
    return std::nullopt;
  }
  const std::string zone = lower_case(words[2]);
  const bool north = zone.ends_with('n');
  if (!north && !zone.ends_with('s')) return std::nullopt;
  const auto number = parse_number<int>(std::string_view(zone).substr(0, zone.size() - 1));
  if (!number || *number < 1 || *number > 60) return std::nullopt;
  return (north ? 32600 : 32700) + *number;
}

bool import_system(const std::string& system, OGRSpatialReference& out) {
  if (const auto code = utm_code(system)) return out.importFromEPSG(*code) == OGRERR_NONE;
  // Only codes and plain projections: other texts would open files and fetch addresses.
  if (system.starts_with("+proj=")) {
    const bool opens_files =
        system.find("grids") != std::string::npos || system.find("+init") != std::string::npos;
    return !opens_files && out.importFromProj4(system.c_str()) == OGRERR_NONE;
  }
  const bool is_code = system.starts_with("EPSG:") && system.size() > 5 &&
                       system.find_first_not_of("0123456789+", 5) == std::string::npos;
  return is_code && out.SetFromUserInput(system.c_str()) == OGRERR_NONE;
}

}  // namespace

struct ProjectedToGeodetic::State {
  OGRSpatialReference system;
  OGRSpatialReference geographic;
  std::unique_ptr<OGRCoordinateTransformation> transformation = {};
};

ProjectedToGeodetic::ProjectedToGeodetic(std::unique_ptr<State> state) : state_(std::move(state)) {}
ProjectedToGeodetic::ProjectedToGeodetic(ProjectedToGeodetic&&) noexcept = default;
ProjectedToGeodetic& ProjectedToGeodetic::operator=(ProjectedToGeodetic&&) noexcept = default;
ProjectedToGeodetic::~ProjectedToGeodetic() = default;

Expected<ProjectedToGeodetic> ProjectedToGeodetic::create(const std::string& system) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);  // GDAL would write to stderr
  auto state = std::make_unique<State>();
  const auto refuse = [&system] {
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{}: not a known coordinate system; give EPSG:n, WGS84 UTM 32N or "
                            "+proj=... in the first line",
                            printable(system)));
  };
  if (!import_system(system, state->system)) return refuse();
  constexpr int kWgs84WithHeight = 4979;
  constexpr int kWgs84 = 4326;
  const bool vertical = state->system.IsVertical() != 0;
  if (state->geographic.importFromEPSG(vertical ? kWgs84WithHeight : kWgs84) != OGRERR_NONE) {
    return refuse();
  }
  state->geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  state->system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationOptions options;
  options.SetBallparkAllowed(!vertical);
  state->transformation.reset(
      OGRCreateCoordinateTransformation(&state->system, &state->geographic, options));
  if (!state->transformation) return refuse();
  return ProjectedToGeodetic(std::move(state));
}

Expected<GeodeticPosition> ProjectedToGeodetic::operator()(const Eigen::Vector3d& point) const {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  Eigen::Vector3d at = point;
  if (state_->transformation->Transform(1, &at.x(), &at.y(), &at.z()) == 0 || !at.allFinite()) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("({:.3f}, {:.3f}) lies outside the coordinate system", point.x(), point.y()));
  }
  return GeodeticPosition{.latitude_deg = at.y(), .longitude_deg = at.x(), .altitude_m = at.z()};
}

}  // namespace hybridfusion
