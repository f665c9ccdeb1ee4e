#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hybridfusion {

/// What the axes of a coordinate system count.
struct AxisUnits {
  double horizontal_m = 1.0;
  std::optional<double> vertical_m = {};  ///< Absent: the system has no heights.
  bool geographic = false;
  bool geocentric = false;
  bool depths = false;  ///< The third axis points down.
};

/// @param text  WKT of either version, ESRI's dialect or "EPSG:n[+m]".
/// @returns nothing for a text that PROJ does not understand.
[[nodiscard]] std::optional<AxisUnits> axis_units(const std::string& text);

/// Two systems one behind the other, as ESRI writes heights: "PROJCS[...],VERTCS[...]". The second
/// is empty when there is one system.
[[nodiscard]] std::pair<std::string, std::string> split_systems(std::string_view wkt);

/// WKT 1 of both together; empty when PROJ cannot.
[[nodiscard]] std::string compound_wkt(const std::string& horizontal, const std::string& vertical);

/// Linear unit of GeoTIFF (EPSG codes 9001, 9002, 9003, ...) in metres.
[[nodiscard]] std::optional<double> metres_of_unit_code(int code);
/// "metre", "foot", "US survey foot" or the number of metres.
[[nodiscard]] std::string unit_name(double metres);

}  // namespace hybridfusion
