#include "text_columns.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// A name without case, quotes, signs and the unit behind it, and that unit.
struct PlainName {
  std::string name = {};
  std::string unit = {};
};

[[nodiscard]] PlainName plain_name(std::string_view text) {
  PlainName plain;
  std::string lower = lower_case(trimmed(text));
  if (const std::size_t open = lower.find_first_of("[("); open != std::string::npos && open > 0) {
    const std::size_t close = lower.find_first_of("])", open);
    if (close != std::string::npos) plain.unit = lower.substr(open + 1, close - open - 1);
    lower.resize(open);
  }
  constexpr std::string_view kCloudCompare = "scalar_";
  if (lower.starts_with(kCloudCompare)) lower.erase(0, kCloudCompare.size());
  for (const char c : lower) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain.name += c;
  }
  return plain;
}

struct Synonyms {
  std::string_view role;
  std::initializer_list<std::string_view> names;  ///< As plain_name gives them, the best first.
};

// CloudCompare, MeshLab, ParaView, ArcGIS, QGIS, Leica, RIEGL, Livox Viewer, LAStools, PDAL.
const std::array<Synonyms, 11> kRoles = {{
    {"x",
     {"x",
      "points0",
      "pointx",
      "xcoord",
      "xcoordinate",
      "coordx",
      "posx",
      "positionx",
      "easting",
      "east",
      "e",
      "rechtswert",
      "ostwert"}},
    {"y",
     {"y",
      "points1",
      "pointy",
      "ycoord",
      "ycoordinate",
      "coordy",
      "posy",
      "positiony",
      "northing",
      "north",
      "n",
      "hochwert",
      "nordwert"}},
    {"z",
     {"z",
      "points2",
      "pointz",
      "zcoord",
      "zcoordinate",
      "coordz",
      "posz",
      "positionz",
      "elevation",
      "elev",
      "height",
      "altitude",
      "alt",
      "h",
      "up",
      "u",
      "hoehe"}},
    {"red", {"red", "r", "rf", "diffusered", "colorr", "colorred"}},
    {"green", {"green", "g", "gf", "diffusegreen", "colorg", "colorgreen"}},
    {"blue", {"blue", "b", "bf", "diffuseblue", "colorb", "colorblue"}},
    {"nx", {"nx", "normalx", "normalsx", "normals0", "normal0"}},
    {"ny", {"ny", "normaly", "normalsy", "normals1", "normal1"}},
    {"nz", {"nz", "normalz", "normalsz", "normals2", "normal2"}},
    {"intensity", {"intensity", "intensities", "reflectivity", "reflectance", "i"}},
    {"time", {"time", "timestamp"}},
}};

constexpr std::array<std::string_view, 2> kLatitude = {"lat", "latitude"};
constexpr std::array<std::string_view, 4> kLongitude = {"lon", "long", "lng", "longitude"};

[[nodiscard]] bool contains(auto&& list, std::string_view name) {
  return std::ranges::find(list, name) != std::end(list);
}

[[nodiscard]] bool is_skipped(std::string_view name) {
  return name == "-" || name == "_" || lower_case(name) == "skip";
}

[[nodiscard]] bool is_metric(std::string_view unit) {
  constexpr std::array<std::string_view, 6> kMetres = {
      "", "m", "metre", "meter", "metres", "meters"};
  return contains(kMetres, unit);
}

}  // namespace

bool names_position(std::span<const std::string_view> names) {
  return std::ranges::all_of(std::span(kRoles).first(3), [names](const Synonyms& role) {
    return std::ranges::any_of(
        names, [&role](std::string_view n) { return contains(role.names, plain_name(n).name); });
  });
}

bool are_known_names(std::span<const std::string_view> names) {
  return std::ranges::all_of(names, [](std::string_view text) {
    const std::string name = plain_name(text).name;
    return contains(kLatitude, name) || contains(kLongitude, name) ||
           std::ranges::any_of(
               kRoles, [&name](const Synonyms& role) { return contains(role.names, name); });
  });
}

TextColumns columns_of_names(std::span<const std::string_view> names) {
  TextColumns columns;
  std::vector<PlainName> plain;
  for (const std::string_view name : names) {
    plain.push_back(is_skipped(name) ? PlainName{} : plain_name(name));
    columns.names.emplace_back(is_skipped(name) ? "" : std::string(trimmed(name)));
  }
  std::string missing;
  for (const Synonyms& role : kRoles) {
    std::vector<std::size_t> found;
    for (const std::string_view synonym : role.names) {
      for (std::size_t i = 0; i < plain.size(); ++i) {
        if (plain[i].name == synonym) found.push_back(i);
      }
      if (!found.empty()) break;
    }
    const bool is_position = role.role.size() == 1;
    if (is_position && found.size() > 1) {
      columns.doubt = fmt::format("several columns are named '{}'", names[found.front()]);
      return columns;
    }
    if (is_position && found.empty()) missing += missing.empty() ? role.role : " and ";
    if (found.empty()) continue;
    columns.names[found.front()] = role.role;
    if (is_position && !is_metric(plain[found.front()].unit)) {
      columns.doubt = fmt::format("column '{}' is not in metres", names[found.front()]);
      columns.remedy = "convert it to metres";
      return columns;
    }
  }
  if (missing.empty()) return columns;
  const auto any_of = [&plain](auto&& list) {
    return std::ranges::any_of(plain,
                               [&list](const PlainName& n) { return contains(list, n.name); });
  };
  columns.doubt = "the heading names no x, y and z";
  if (any_of(kLatitude) && any_of(kLongitude)) {
    columns.doubt = "its columns are latitude and longitude in degrees, not metres";
    columns.remedy = "project them first, for example to UTM (cs2cs of proj-bin, QGIS)";
  }
  return columns;
}

namespace {

/// Each row of three columns, as far as it is finite.
[[nodiscard]] bool all_rows(const TextSample& sample, std::size_t from, auto&& holds) {
  for (std::size_t row = 0; row < sample.columns[from].values.size(); ++row) {
    const std::array<double, 3> v = {sample.columns[from].values[row],
                                     sample.columns[from + 1].values[row],
                                     sample.columns[from + 2].values[row]};
    if (std::ranges::all_of(v, [](double c) { return std::isfinite(c); }) && !holds(v))
      return false;
  }
  return true;
}

[[nodiscard]] bool are_integers(const TextSample& sample, std::size_t from) {
  return sample.columns[from].integers && sample.columns[from + 1].integers &&
         sample.columns[from + 2].integers;
}

/// Of unit length, or 0 where there is none. Three decimals leave 0.002.
[[nodiscard]] bool may_be_normals(const TextSample& sample, std::size_t from) {
  constexpr double kRounding = 0.01;
  bool any = false;
  return all_rows(sample,
                  from,
                  [&any](const std::array<double, 3>& v) {
                    const double length = std::hypot(v[0], v[1], v[2]);
                    any = any || length > 0.0;
                    return length == 0.0 || std::abs(length - 1.0) < kRounding;
                  }) &&
         any;
}

[[nodiscard]] bool may_be_colors(const TextSample& sample, std::size_t from) {
  if (may_be_normals(sample, from)) return false;
  // Whole numbers to 255 or fractions to 1, all three alike.
  const bool whole = are_integers(sample, from);
  for (std::size_t i = from; i < from + 3; ++i) {
    if (sample.columns[i].integers != whole) return false;
  }
  const double most = whole ? 255.0 : 1.0;
  return all_rows(sample, from, [most](const std::array<double, 3>& v) {
    return std::ranges::all_of(v, [most](double c) { return c >= 0.0 && c <= most; });
  });
}

/// Rows counted 0, 1, 2, ... in the first column.
[[nodiscard]] bool counts_rows(const TextSample& sample) {
  constexpr std::size_t kFewest = 3;
  const TextSample::Column& first = sample.columns.front();
  if (!first.integers || first.values.size() < kFewest) return false;
  for (std::size_t i = 1; i < first.values.size(); ++i) {
    if (first.values[i] != first.values[i - 1] + 1.0) return false;
  }
  return true;
}

/// The layouts behind x y z: i intensity, c colour, n normal.
constexpr std::array<std::string_view, 11> kLayouts = {
    "i", "c", "n", "ic", "ci", "in", "ni", "cn", "nc", "icn", "cin"};

[[nodiscard]] std::size_t width_of(std::string_view layout) {
  std::size_t width = 0;
  for (const char part : layout) width += part == 'i' ? 1 : 3;
  return width;
}

[[nodiscard]] bool fits(std::string_view layout, const TextSample& sample) {
  std::size_t at = 3;
  if (width_of(layout) + at != sample.columns.size()) return false;
  for (const char part : layout) {
    if (part == 'c' && !may_be_colors(sample, at)) return false;
    if (part == 'n' && !may_be_normals(sample, at)) return false;
    at += part == 'i' ? 1 : 3;
  }
  return true;
}

}  // namespace

TextColumns guess_columns(const TextSample& sample, bool is_pts) {
  TextColumns columns;
  const std::size_t count = sample.columns.size();
  columns.names = {"x", "y", "z"};
  if (count == 3) return columns;
  // Seconds since 1970 are larger than any coordinate on Earth.
  constexpr double kFewestSeconds = 1e8;
  const std::vector<double>& first = sample.columns.front().values;
  if (counts_rows(sample)) {
    columns.doubt = "the first column counts the rows, and no heading names the others";
    return columns;
  }
  if (!first.empty() && first.front() > kFewestSeconds) {
    columns.doubt = "the first column looks like a time, and no heading names the others";
    return columns;
  }
  std::vector<std::string_view> possible;
  for (const std::string_view layout : kLayouts) {
    if (fits(layout, sample)) possible.push_back(layout);
  }
  if (possible.size() > 1 && is_pts && contains(possible, "ic")) possible = {"ic"};
  if (possible.size() != 1) {
    columns.doubt = fmt::format("no heading says what its {} columns are", count);
    return columns;
  }
  for (const char part : possible.front()) {
    if (part == 'i') columns.names.emplace_back("intensity");
    if (part == 'c') columns.names.insert(columns.names.end(), {"red", "green", "blue"});
    if (part == 'n') columns.names.insert(columns.names.end(), {"nx", "ny", "nz"});
  }
  return columns;
}

}  // namespace hybridfusion
