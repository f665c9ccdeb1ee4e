#include "coordinate_checks.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

bool in_degrees(const Eigen::Vector3d& written) {
  return std::abs(written.x()) <= 180.0 && std::abs(written.y()) <= 180.0;
}

/// Rows within one unit of each other: no flight and no survey in metres or feet.
bool is_tiny(std::span<const Eigen::Vector3d> written) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& row : written) box.extend(Eigen::Vector2d(row.head<2>()));
  return written.size() > 1 && box.diagonal().maxCoeff() < 1.0;
}

bool covers_swapped(const CoordinateSystem& system, const Eigen::Vector3d& written) {
  const auto at = system({written.y(), written.x(), 0.0});
  return at && on_earth(*at) && system.covers(*at);
}

std::unexpected<Error> refuse(const CoordinateTable& table, const std::string& cause) {
  return fail(
      ErrorCode::kParse,
      fmt::format("{}: {}; correct the first line or the columns", table.path().string(), cause));
}

}  // namespace

bool on_earth(const GeodeticPosition& position) {
  return std::isfinite(position.altitude_m) && std::abs(position.latitude_deg) <= 90.0 &&
         std::abs(position.longitude_deg) <= 180.0;
}

Expected<CoordinateSystem> system_of_line(const CoordinateTable& table, const std::string& line) {
  auto system = CoordinateSystem::create(line);
  if (!system) {
    return std::unexpected(std::move(system.error()).with_context(table.path().string()));
  }
  return system;
}

std::string hint_of(const Eigen::Vector3d& written, const CoordinateSystem& system) {
  if (!system.is_geographic()) {
    return covers_swapped(system, written) ? ": these look like easting and northing swapped" : "";
  }
  if (in_degrees(written)) {
    return std::abs(written.x()) <= 90.0 ? ": these look like latitude and longitude swapped" : "";
  }
  return ": these look like metres, not degrees; name the projected system, e.g. WGS84 UTM 32N";
}

Expected<void> check_written(const CoordinateTable& table,
                             const CoordinateSystem& system,
                             std::span<const Eigen::Vector3d> written,
                             std::span<const GeodeticPosition> positions,
                             std::vector<std::string>& notes) {
  if (written.empty()) return refuse(table, "no row behind the first line");
  // The origin of a projected system lies far from any place that it is made for.
  if (!system.is_geographic() && std::ranges::all_of(written, in_degrees) &&
      (!system.covers(positions.front()) || is_tiny(written))) {
    return refuse(table,
                  fmt::format("({:g}, {:g}) under {}: these look like degrees, not coordinates of "
                              "a projected system",
                              written.front().x(),
                              written.front().y(),
                              printable(system.text())));
  }
  const auto outside = std::ranges::find_if_not(
      positions, [&](const GeodeticPosition& position) { return system.covers(position); });
  if (outside != positions.end()) {
    const Eigen::Vector3d& row = written[static_cast<std::size_t>(outside - positions.begin())];
    if (!system.is_geographic() && covers_swapped(system, row)) {
      return refuse(table,
                    fmt::format("({:.2f}, {:.2f}) under {}: these look like easting and northing "
                                "swapped",
                                row.x(),
                                row.y(),
                                printable(system.text())));
    }
    notes.push_back(
        fmt::format("{}: latitude {:.4f}, longitude {:.4f} lies far outside the area "
                    "that {} is made for",
                    table.path().string(),
                    outside->latitude_deg,
                    outside->longitude_deg,
                    printable(system.text())));
  }
  const bool has_heights =
      std::ranges::any_of(written, [](const Eigen::Vector3d& row) { return row.z() != 0.0; });
  if (system.metres_per_height_unit() != 1.0 && has_heights) {
    notes.push_back(fmt::format("{}: heights are taken in the unit of {}, {} ({:.6f} m)",
                                table.path().string(),
                                printable(system.text()),
                                system.unit_name(),
                                system.metres_per_height_unit()));
  }
  return {};
}

}  // namespace hybridfusion
