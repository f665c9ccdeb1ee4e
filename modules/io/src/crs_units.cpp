#include "crs_units.hpp"

#include "text.hpp"

#include <array>
#include <cmath>
#include <memory>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>
#include <proj.h>

namespace hybridfusion {
namespace {

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Context = std::unique_ptr<PJ_CONTEXT, DestroyContext>;
using Object = std::unique_ptr<PJ, DestroyObject>;

[[nodiscard]] Context quiet_context() {
  Context context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  return context;
}

[[nodiscard]] Object parse(PJ_CONTEXT* context, const std::string& text) {
  if (text.starts_with("EPSG:")) return Object(proj_create(context, text.c_str()));
  PROJ_STRING_LIST warnings = nullptr;
  PROJ_STRING_LIST errors = nullptr;
  Object object(proj_create_from_wkt(context, text.c_str(), nullptr, &warnings, &errors));
  proj_string_list_destroy(warnings);
  proj_string_list_destroy(errors);
  return object;
}

void take_axes(PJ_CONTEXT* context, const PJ* crs, AxisUnits& units) {
  const PJ_TYPE type = proj_get_type(crs);
  if (type == PJ_TYPE_COMPOUND_CRS) {
    for (int part = 0; part < 2; ++part) {
      const Object sub(proj_crs_get_sub_crs(context, crs, part));
      if (sub) take_axes(context, sub.get(), units);
    }
    return;
  }
  if (type == PJ_TYPE_BOUND_CRS) {
    const Object source(proj_get_source_crs(context, crs));
    if (source) take_axes(context, source.get(), units);
    return;
  }
  units.geocentric = units.geocentric || type == PJ_TYPE_GEOCENTRIC_CRS;
  units.geographic =
      units.geographic || type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
  const Object system(proj_crs_get_coordinate_system(context, crs));
  if (!system) return;
  const int count = proj_cs_get_axis_count(context, system.get());
  for (int axis = 0; axis < count; ++axis) {
    const char* direction = nullptr;
    double factor = 1.0;
    if (proj_cs_get_axis_info(context,
                              system.get(),
                              axis,
                              nullptr,
                              nullptr,
                              &direction,
                              &factor,
                              nullptr,
                              nullptr,
                              nullptr) == 0) {
      continue;
    }
    const std::string way = lower_case(direction == nullptr ? "" : direction);
    if (way == "up" || way == "down" || type == PJ_TYPE_VERTICAL_CRS) {
      units.vertical_m = factor;
      units.depths = units.depths || way == "down";
    } else if (!units.geographic) {
      units.horizontal_m = factor;
    }
  }
}

struct Unit {
  int code;
  double metres;
  std::string_view name;
};
// EPSG registry, units of length that systems of countries use.
constexpr std::array<Unit, 11> kUnits = {{{9001, 1.0, "metre"},
                                          {9002, 0.3048, "foot"},
                                          {9003, 1200.0 / 3937.0, "US survey foot"},
                                          {9005, 0.3047972654, "Clarke's foot"},
                                          {9030, 1852.0, "nautical mile"},
                                          {9036, 1000.0, "kilometre"},
                                          {9037, 0.9143917962, "Clarke's yard"},
                                          {9093, 1609.344, "mile"},
                                          {9096, 0.9144, "yard"},
                                          {1025, 0.001, "millimetre"},
                                          {1033, 0.01, "centimetre"}}};

}  // namespace

std::optional<AxisUnits> axis_units(const std::string& text) {
  const Context context = quiet_context();
  const Object crs = parse(context.get(), text);
  if (!crs || proj_is_crs(crs.get()) == 0) return std::nullopt;
  AxisUnits units;
  take_axes(context.get(), crs.get(), units);
  return units;
}

std::pair<std::string, std::string> split_systems(std::string_view wkt) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < wkt.size(); ++i) {
    const char c = wkt[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '[' || c == '(') ++depth;
    if ((c != ']' && c != ')') || --depth > 0) continue;
    const std::size_t comma = wkt.find(',', i);
    if (comma == std::string_view::npos) break;
    return {std::string(wkt.substr(0, i + 1)), std::string(trimmed(wkt.substr(comma + 1)))};
  }
  return {std::string(wkt), ""};
}

std::string compound_wkt(const std::string& horizontal, const std::string& vertical) {
  const Context context = quiet_context();
  const Object flat = parse(context.get(), horizontal);
  const Object high = parse(context.get(), vertical);
  if (!flat || !high) return {};
  const auto system_of = [&context](const PJ* crs, OGRSpatialReference& out) {
    const char* const wkt = proj_as_wkt(context.get(), crs, PJ_WKT2_2019, nullptr);
    return wkt != nullptr && out.importFromWkt(wkt) == OGRERR_NONE;
  };
  const CPLErrorHandlerPusher silent(CPLQuietErrorHandler);
  OGRSpatialReference flat_system;
  OGRSpatialReference high_system;
  OGRSpatialReference both;
  const std::string name =
      fmt::format("{} + {}", proj_get_name(flat.get()), proj_get_name(high.get()));
  if (!system_of(flat.get(), flat_system) || !system_of(high.get(), high_system) ||
      both.SetCompoundCS(name.c_str(), &flat_system, &high_system) != OGRERR_NONE) {
    return {};
  }
  char* text = nullptr;
  std::string wkt;
  if (both.exportToWkt(&text) == OGRERR_NONE && text != nullptr) wkt = text;
  CPLFree(text);
  return wkt;
}

std::optional<double> metres_of_unit_code(int code) {
  for (const Unit& unit : kUnits) {
    if (unit.code == code) return unit.metres;
  }
  return std::nullopt;
}

std::string unit_name(double metres) {
  // The feet differ by 2e-6; files round them to 9 digits and more.
  constexpr double kRounding = 1e-8;
  for (const Unit& unit : kUnits) {
    if (std::abs(unit.metres / metres - 1.0) < kRounding) return std::string(unit.name);
  }
  return fmt::format("{:.9g} m", metres);
}

}  // namespace hybridfusion
