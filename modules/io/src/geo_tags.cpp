#include "crs.hpp"
#include "text.hpp"
#include "text_lines.hpp"

#include <hybridfusion/io/geo_tags.hpp>

#include <array>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kRemedy =
    "give the coordinate system in the first line (EPSG:4326, WGS84 UTM 32N), then one photo a "
    "line";

/// Lines that hold something, split; comments are dropped.
class Table {
 public:
  [[nodiscard]] static Expected<Table> open(const std::filesystem::path& path) {
    HF_TRY(TextLines lines, TextLines::open(path));
    return Table(std::move(lines));
  }

  [[nodiscard]] Expected<std::optional<std::string>> next() {
    while (true) {
      HF_TRY(const auto line, lines_.next());
      if (!line) return std::optional<std::string>{};
      const std::string_view text = trimmed(*line);
      if (!text.empty() && !text.starts_with('#')) return std::optional<std::string>(text);
    }
  }

  [[nodiscard]] std::unexpected<Error> malformed(std::string_view cause) const {
    return lines_.malformed(cause, kRemedy);
  }

 private:
  explicit Table(TextLines lines) : lines_(std::move(lines)) {}
  TextLines lines_;
};

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  if (line.find(',') != std::string::npos) {
    for (const std::string_view field : split_fields(line, ',')) fields.emplace_back(field);
  } else {
    for (const std::string_view word : split_words(line)) fields.emplace_back(word);
  }
  return fields;
}

std::optional<double> finite(const std::vector<std::string>& fields, std::size_t at) {
  if (at >= fields.size()) return std::nullopt;
  const auto number = parse_number<double>(fields[at]);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// A deviation that says something.
std::optional<double> positive(const std::vector<std::string>& fields, std::size_t at) {
  const auto number = finite(fields, at);
  return number && *number > 0.0 ? number : std::nullopt;
}

bool on_earth(const GeodeticPosition& position) {
  return std::isfinite(position.altitude_m) && std::abs(position.latitude_deg) <= 90.0 &&
         std::abs(position.longitude_deg) <= 180.0;
}

/// name,lat,lon[,alt[,sigma_h[,sigma_v]]]
std::optional<GeoTag> tag_of_csv(const std::vector<std::string>& fields) {
  const auto latitude = finite(fields, 1);
  const auto longitude = finite(fields, 2);
  if (fields.front().empty() || !latitude || !longitude) return std::nullopt;
  GeoTag tag{.photo = fields.front(),
             .latitude_deg = *latitude,
             .longitude_deg = *longitude,
             .altitude_m = finite(fields, 3),
             .sigma_horizontal_m = positive(fields, 4),
             .sigma_vertical_m = positive(fields, 5)};
  if (!on_earth({.latitude_deg = *latitude, .longitude_deg = *longitude})) return std::nullopt;
  return tag;
}

Expected<std::vector<GeoTag>> read_csv(Table& table, const std::string& first) {
  std::vector<GeoTag> tags;
  // A heading is a first line whose second column is no number.
  bool heading = true;
  std::optional<std::string> line = first;
  while (line) {
    const std::vector<std::string> fields = fields_of(*line);
    const auto tag = tag_of_csv(fields);
    if (!tag && !(heading && !finite(fields, 1))) {
      return table.malformed("not name, latitude and longitude in degrees");
    }
    if (tag) tags.push_back(*tag);
    heading = false;
    HF_TRY(line, table.next());
  }
  return tags;
}

Expected<std::vector<GeoTag>> read_rows(Table& table, const ProjectedToGeodetic& to_geodetic) {
  std::vector<GeoTag> tags;
  while (true) {
    HF_TRY(const auto line, table.next());
    if (!line) return tags;
    const std::vector<std::string> fields = fields_of(*line);
    const auto x = finite(fields, 1);
    const auto y = finite(fields, 2);
    if (!x || !y) return table.malformed("not a photo name and two coordinates");
    const auto z = finite(fields, 3);
    auto position = to_geodetic({*x, *y, z.value_or(0.0)});
    if (!position || !on_earth(*position)) {
      return table.malformed("the coordinates lie outside the coordinate system");
    }
    // Three angles may stand before the accuracies.
    tags.push_back({.photo = fields.front(),
                    .latitude_deg = position->latitude_deg,
                    .longitude_deg = position->longitude_deg,
                    .altitude_m = z ? std::optional(position->altitude_m) : std::nullopt,
                    .sigma_horizontal_m = positive(fields, 7),
                    .sigma_vertical_m = positive(fields, 8)});
  }
}

}  // namespace

Expected<std::vector<GeoTag>> read_geo_tags(const std::filesystem::path& path) {
  HF_TRY(Table table, Table::open(path));
  HF_TRY(const auto first, table.next());
  if (!first) return table.malformed("the file is empty");
  const bool is_proj = first->starts_with('+');
  if (!is_proj && first->find(',') != std::string::npos) return read_csv(table, *first);
  HF_TRY(const ProjectedToGeodetic to_geodetic, ProjectedToGeodetic::create(*first));
  return read_rows(table, to_geodetic);
}

std::size_t apply_geo_tags(std::span<const GeoTag> tags, std::span<Photo> photos) {
  std::unordered_map<std::string, const GeoTag*> by_name;
  for (const GeoTag& tag : tags) by_name[tag.photo] = &tag;
  std::size_t tagged = 0;
  for (Photo& photo : photos) {
    const auto found = by_name.find(photo.metadata.name);
    if (found == by_name.end()) continue;
    const GeoTag& tag = *found->second;
    PhotoMetadata& metadata = photo.metadata;
    metadata.latitude_deg = tag.latitude_deg;
    metadata.longitude_deg = tag.longitude_deg;
    metadata.altitude_m = tag.altitude_m;
    metadata.absolute_altitude_m = tag.altitude_m;
    metadata.gps_dop.reset();
    metadata.gps_horizontal_error_m = tag.sigma_horizontal_m;
    metadata.rtk_sigma_enu_m.reset();
    if (tag.sigma_horizontal_m && tag.sigma_vertical_m) {
      metadata.rtk_sigma_enu_m = {
          *tag.sigma_horizontal_m, *tag.sigma_horizontal_m, *tag.sigma_vertical_m};
    }
    ++tagged;
  }
  return tagged;
}

Expected<std::vector<SurveyedPoint>> read_surveyed_points(const std::filesystem::path& path) {
  constexpr double kCorner_px = 0.5;  // pixels counted from the corner of the first one
  HF_TRY(Table table, Table::open(path));
  HF_TRY(const auto first, table.next());
  if (!first) return table.malformed("the file is empty");
  HF_TRY(const ProjectedToGeodetic to_geodetic, ProjectedToGeodetic::create(*first));
  std::vector<SurveyedPoint> points;
  std::unordered_map<std::string, std::size_t> index;
  while (true) {
    HF_TRY(const auto line, table.next());
    if (!line) return points;
    const std::vector<std::string> fields = fields_of(*line);
    std::array<double, 5> numbers{};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const auto number = finite(fields, k);
      if (!number) return table.malformed("not x y z, pixel x, pixel y and a photo name");
      numbers[k] = *number;
    }
    if (fields.size() < 6) return table.malformed("the photo name is missing");
    const std::string name =
        fields.size() > 6 ? fields[6] : fmt::format("{} {} {}", fields[0], fields[1], fields[2]);
    const auto [known, fresh] = index.try_emplace(name, points.size());
    if (fresh) {
      auto position = to_geodetic({numbers[0], numbers[1], numbers[2]});
      if (!position || !on_earth(*position)) {
        return table.malformed("the coordinates lie outside the coordinate system");
      }
      points.push_back({.name = name, .position = *position});
    }
    points[known->second].marks.push_back(
        {.photo = fields[5], .pixel = {numbers[3] - kCorner_px, numbers[4] - kCorner_px}});
  }
}

}  // namespace hybridfusion
