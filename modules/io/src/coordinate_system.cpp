#include "coordinate_system.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

namespace hybridfusion {
namespace {

constexpr std::array kWktStarts = {
    "projcs[", "geogcs[", "compd_cs[", "projcrs[", "geogcrs[", "compoundcrs[", "geodcrs["};

bool starts_as_wkt(std::string_view lower) {
  return std::ranges::any_of(kWktStarts,
                             [lower](const char* start) { return lower.starts_with(start); });
}

/// EPSG code of "WGS84 UTM 32N", "WGS 84 / UTM zone 32 N", "wgs84/utm 32n"; nothing for another
/// text.
std::optional<int> utm_code(std::string_view text) {
  std::string rest = lower_case(text);
  std::ranges::replace_if(rest, [](char c) { return c == '/' || c == '_' || c == ','; }, ' ');
  std::string joined;
  for (const std::string_view word : split_words(rest)) joined += word;
  constexpr std::string_view kStart = "wgs84utm";
  if (!joined.starts_with(kStart)) return std::nullopt;
  std::string_view zone = std::string_view(joined).substr(kStart.size());
  if (zone.starts_with("zone")) zone.remove_prefix(4);
  const bool north = zone.ends_with('n');
  if (!north && !zone.ends_with('s')) return std::nullopt;
  const auto number = parse_number<int>(zone.substr(0, zone.size() - 1));
  if (!number || *number < 1 || *number > 60) return std::nullopt;
  return (north ? 32600 : 32700) + *number;
}

/// "EPSG:n" or "EPSG:n+m" of "epsg: 2263", "EPSG 2263+5703", "+init=epsg:2263"; else empty.
std::string code_text(std::string_view text) {
  std::string lower;
  for (const std::string_view word : split_words(text)) lower += lower_case(word);
  if (lower.starts_with("+init=")) lower.erase(0, 6);
  if (!lower.starts_with("epsg")) return {};
  std::string_view digits = std::string_view(lower).substr(4);
  while (digits.starts_with(':')) digits.remove_prefix(1);
  if (const std::size_t further = digits.find("epsg:"); further != std::string_view::npos) {
    // "EPSG:2263+EPSG:5703"
    return code_text(
        fmt::format("epsg:{}{}", digits.substr(0, further), digits.substr(further + 5)));
  }
  if (digits.empty() || digits.find_first_not_of("0123456789+") != std::string_view::npos)
    return {};
  return fmt::format("EPSG:{}", digits);
}

bool import_system(std::string_view text, OGRSpatialReference& out) {
  if (const auto code = utm_code(text)) return out.importFromEPSG(*code) == OGRERR_NONE;
  if (const std::string code = code_text(text); !code.empty()) {
    return out.SetFromUserInput(code.c_str()) == OGRERR_NONE;
  }
  // Only codes and plain projections: other texts would open files and fetch addresses.
  const std::string whole(text);
  if (whole.find("+proj=") != std::string::npos) {
    const bool opens_files =
        whole.find("grids") != std::string::npos || whole.find("+init") != std::string::npos;
    return !opens_files && out.importFromProj4(whole.c_str()) == OGRERR_NONE;
  }
  return starts_as_wkt(lower_case(text)) && out.importFromWkt(whole.c_str()) == OGRERR_NONE;
}

}  // namespace

bool names_coordinate_system(std::string_view line) {
  const std::string lower = lower_case(trimmed(line));
  return lower.starts_with("epsg") || lower.starts_with('+') || starts_as_wkt(lower) ||
         (lower.starts_with("wgs") && lower.find("utm") != std::string::npos);
}

struct CoordinateSystem::State {
  std::string text = {};
  OGRSpatialReference system;
  OGRSpatialReference geographic;
  std::unique_ptr<OGRCoordinateTransformation> transformation = {};
  double metres_per_height_unit = 1.0;
  std::string unit_name = {};
  bool has_area = false;
  double west_deg = 0.0;
  double south_deg = 0.0;
  double east_deg = 0.0;
  double north_deg = 0.0;
};

CoordinateSystem::CoordinateSystem(std::unique_ptr<State> state) : state_(std::move(state)) {}
CoordinateSystem::CoordinateSystem(CoordinateSystem&&) noexcept = default;
CoordinateSystem& CoordinateSystem::operator=(CoordinateSystem&&) noexcept = default;
CoordinateSystem::~CoordinateSystem() = default;

Expected<CoordinateSystem> CoordinateSystem::create(std::string_view text) {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);  // GDAL would write to stderr
  auto state = std::make_unique<State>();
  state->text = trimmed(text);
  const auto refuse = [&state](std::string_view cause) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: {}; give EPSG:n, WGS84 UTM 32N or +proj=... in the first line",
                            printable(state->text),
                            cause));
  };
  OGRSpatialReference& system = state->system;
  if (!import_system(state->text, system)) return refuse("not a known coordinate system");
  if (system.IsGeographic() == 0 && system.IsProjected() == 0) {
    return refuse("neither a geographic nor a projected coordinate system");
  }
  constexpr int kWgs84WithHeight = 4979;
  constexpr int kWgs84 = 4326;
  const bool vertical = system.IsVertical() != 0;
  if (state->geographic.importFromEPSG(vertical ? kWgs84WithHeight : kWgs84) != OGRERR_NONE) {
    return refuse("the database of PROJ is missing");
  }
  const char* unit = nullptr;
  const double metres_per_unit = system.IsGeographic() != 0 ? 1.0 : system.GetLinearUnits(&unit);
  if (unit != nullptr) state->unit_name = unit;
  if (!vertical) state->metres_per_height_unit = metres_per_unit;
  const char* area = nullptr;
  state->has_area = system.GetAreaOfUse(
      &state->west_deg, &state->south_deg, &state->east_deg, &state->north_deg, &area);
  state->geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRCoordinateTransformationOptions options;
  // A "ballpark" transformation would leave heights above sea level as they are.
  options.SetBallparkAllowed(!vertical);
  state->transformation.reset(
      OGRCreateCoordinateTransformation(&system, &state->geographic, options));
  if (!state->transformation) {
    return refuse(vertical ? "its heights need a geoid model that is not installed (proj-data); "
                             "give ellipsoidal heights with the horizontal code alone"
                           : "PROJ cannot convert it to WGS84");
  }
  return CoordinateSystem(std::move(state));
}

Expected<GeodeticPosition> CoordinateSystem::operator()(const Eigen::Vector3d& point) const {
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  Eigen::Vector3d at = point;
  at.z() *= state_->metres_per_height_unit;
  if (state_->transformation->Transform(1, &at.x(), &at.y(), &at.z()) == 0 || !at.allFinite()) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("({:.3f}, {:.3f}) lies outside the coordinate system", point.x(), point.y()));
  }
  return GeodeticPosition{.latitude_deg = at.y(), .longitude_deg = at.x(), .altitude_m = at.z()};
}

const std::string& CoordinateSystem::text() const {
  return state_->text;
}

bool CoordinateSystem::is_geographic() const {
  return state_->system.IsGeographic() != 0;
}

double CoordinateSystem::metres_per_height_unit() const {
  return state_->metres_per_height_unit;
}

const std::string& CoordinateSystem::unit_name() const {
  return state_->unit_name;
}

bool CoordinateSystem::covers(const GeodeticPosition& position) const {
  constexpr double kMargin_deg = 3.0;
  if (!state_->has_area) return true;
  const bool in_latitude = position.latitude_deg >= state_->south_deg - kMargin_deg &&
                           position.latitude_deg <= state_->north_deg + kMargin_deg;
  const double west = state_->west_deg - kMargin_deg;
  const double width = std::remainder(state_->east_deg - state_->west_deg, 360.0);
  const double span = (width < 0.0 ? width + 360.0 : width) + 2.0 * kMargin_deg;
  const double from_west = std::fmod(position.longitude_deg - west + 720.0, 360.0);
  const bool whole = state_->east_deg - state_->west_deg >= 360.0;
  return in_latitude && (whole || from_west <= span);
}

}  // namespace hybridfusion
