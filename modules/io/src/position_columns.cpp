#include "position_columns.hpp"

#include "coordinate_table.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace hybridfusion {
namespace {

/// Lower case, letters and digits only: "X/Longitude" -> "xlongitude", "Lat (deg)" -> "latdeg".
std::string key_of(std::string_view heading) {
  std::string key = lower_case(heading);
  std::erase_if(key, [](char c) { return !(c >= 'a' && c <= 'z') && !(c >= '0' && c <= '9'); });
  return key;
}

bool holds(const std::string& key, std::string_view word) {
  return key.find(word) != std::string::npos;
}

bool is_one_of(const std::string& key, auto... words) {
  return ((key == words) || ...);
}

bool is_accuracy(const std::string& key) {
  return holds(key, "acc") || holds(key, "sigma") || holds(key, "std") || holds(key, "error") ||
         is_one_of(key, "sx", "sy", "sz", "sh", "sv");
}

bool is_vertical_accuracy(const std::string& key) {
  return holds(key, "ver") || holds(key, "alt") || holds(key, "height") || key.ends_with('v') ||
         key.ends_with('z') || key.ends_with("zm");
}

}  // namespace

std::optional<PositionColumns> columns_of_heading(std::string_view line) {
  std::vector<std::string> fields = split_row(line);
  if (fields.size() < 3) return std::nullopt;
  std::optional<std::size_t> name;
  std::optional<std::size_t> x;
  std::optional<std::size_t> y;
  bool in_degrees = false;
  PositionColumns columns{.z = {}, .sigma_horizontal = {}, .sigma_vertical = {}};
  const auto set = [](std::optional<std::size_t>& column, std::size_t at) {
    if (!column) column = at;  // the first of its kind: what follows are estimates and errors
  };
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string key = key_of(fields[k]);
    if (is_accuracy(key)) {
      set(is_vertical_accuracy(key) ? columns.sigma_vertical : columns.sigma_horizontal, k);
    } else if (holds(key, "longitude") || is_one_of(key, "lon", "lng", "long", "londeg")) {
      in_degrees = true;
      set(x, k);
    } else if (holds(key, "latitude") || is_one_of(key, "lat", "latdeg")) {
      in_degrees = true;
      set(y, k);
    } else if (holds(key, "east") || is_one_of(key, "x", "xm")) {
      set(x, k);
    } else if (holds(key, "north") || is_one_of(key, "y", "ym")) {
      set(y, k);
    } else if (holds(key, "altitude") || holds(key, "height") || holds(key, "elevation") ||
               is_one_of(key, "z", "zm", "alt", "altm", "h", "elev")) {
      set(columns.z, k);
    } else if (holds(key, "name") || holds(key, "file") || holds(key, "label") ||
               holds(key, "image") || holds(key, "photo")) {
      set(name, k);
    }
  }
  if (!name || !x || !y) return std::nullopt;
  columns.name = *name;
  columns.x = *x;
  columns.y = *y;
  columns.in_degrees = in_degrees;
  return columns;
}

}  // namespace hybridfusion
