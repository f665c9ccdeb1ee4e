#include "coordinate_checks.hpp"
#include "coordinate_system.hpp"
#include "coordinate_table.hpp"
#include "position_columns.hpp"

#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// The fields in the order name x y z sigma_h sigma_v.
std::vector<std::string> ordered(const CoordinateRow& row, const PositionColumns& columns) {
  std::vector<std::string> all = row.before;
  all.push_back(row.photo);
  all.insert(all.end(), row.after.begin(), row.after.end());
  const auto field = [&all](std::optional<std::size_t> at) {
    return at && *at < all.size() ? all[*at] : std::string();
  };
  return {field(columns.name),
          field(columns.x),
          field(columns.y),
          field(columns.z),
          field(columns.sigma_horizontal),
          field(columns.sigma_vertical)};
}

/// One file: the system, the columns, and the rows.
class GeoTagReader {
 public:
  GeoTagReader(CoordinateTable& table, CoordinateSystem system, PositionColumns columns)
      : table_(table), system_(std::move(system)), columns_(columns) {
    file_.system = system_.text();
  }

  Expected<GeoTagFile> read(std::optional<std::string> line) {
    bool first = true;
    while (true) {
      if (!line) {
        HF_TRY(line, table_.next());
      }
      if (!line) break;
      if (auto taken = take(*line, first); !taken) return std::unexpected(taken.error());
      first = false;
      line.reset();
    }
    if (auto checked = check_written(table_, system_, written_, positions_, file_.notes);
        !checked) {
      return std::unexpected(checked.error());
    }
    return std::move(file_);
  }

 private:
  Expected<void> take(const std::string& line, bool first) {
    const auto row = row_of(line, columns_.name);
    const std::vector<std::string> fields =
        row ? ordered(*row, columns_) : std::vector<std::string>();
    const auto x = finite_field(fields, 1);
    const auto y = finite_field(fields, 2);
    if (!x || !y || fields.front().empty()) {
      // A heading is a first line without coordinates; its words say what stands where.
      if (first && !has_numbers(line)) {
        if (const auto named = columns_of_heading(line)) columns_ = *named;
        return {};
      }
      return table_.malformed(columns_.in_degrees ? "not name, latitude and longitude in degrees"
                                                  : "not a photo name and two coordinates");
    }
    const auto z = finite_field(fields, 3);
    const Eigen::Vector3d written(*x, *y, z.value_or(0.0));
    const auto position = system_(written);
    if (!position || !on_earth(*position)) {
      return table_.malformed("the coordinates lie outside the coordinate system" +
                              hint_of(written, system_));
    }
    written_.push_back(written);
    positions_.push_back(*position);
    file_.tags.push_back({.photo = fields.front(),
                          .latitude_deg = position->latitude_deg,
                          .longitude_deg = position->longitude_deg,
                          .altitude_m = z ? std::optional(position->altitude_m) : std::nullopt,
                          .sigma_horizontal_m = positive_field(fields, 4),
                          .sigma_vertical_m = positive_field(fields, 5),
                          .written = written});
    return {};
  }

  /// Then it is a row, not a heading.
  static bool has_numbers(const std::string& line) {
    return std::ranges::any_of(split_row(line), [](const std::string& field) {
      return finite_field({field}, 0).has_value();
    });
  }

  CoordinateTable& table_;
  CoordinateSystem system_;
  PositionColumns columns_;
  GeoTagFile file_ = {};
  std::vector<Eigen::Vector3d> written_ = {};
  std::vector<GeodeticPosition> positions_ = {};
};

std::optional<PositionColumns> columns_of_comments(const CoordinateTable& table) {
  for (const std::string& comment : table.comments()) {
    if (const auto columns = columns_of_heading(comment)) return columns;
  }
  return std::nullopt;
}

/// "# CoordinateSystem: PROJCS[...]" of Metashape; empty without one.
std::string system_of_comments(const CoordinateTable& table) {
  constexpr std::string_view kStart = "CoordinateSystem:";
  for (const std::string& comment : table.comments()) {
    if (comment.starts_with(kStart)) return comment.substr(kStart.size());
  }
  return {};
}

/// A table without a line for the system: degrees in the order of its heading, else name, latitude,
/// longitude.
Expected<GeoTagFile> read_degrees(CoordinateTable& table, const std::string& first) {
  HF_TRY(CoordinateSystem wgs84, CoordinateSystem::create("EPSG:4326"));
  auto columns = columns_of_heading(first);
  if (!columns) columns = columns_of_comments(table);
  if (columns && !columns->in_degrees) {
    const std::string named = system_of_comments(table);
    if (named.empty()) {
      return table.malformed("the columns are x and y of a coordinate system that is not named");
    }
    HF_TRY(CoordinateSystem system, system_of_line(table, named));
    return GeoTagReader(table, std::move(system), *columns).read(first);
  }
  const PositionColumns plain = {
      .x = 2, .y = 1, .z = 3, .sigma_horizontal = 4, .sigma_vertical = 5, .in_degrees = true};
  return GeoTagReader(table, std::move(wgs84), columns.value_or(plain)).read(first);
}

}  // namespace

Expected<GeoTagFile> read_geo_tags(const std::filesystem::path& path) {
  HF_TRY(CoordinateTable table, CoordinateTable::open(path));
  HF_TRY(const auto first, table.next());
  if (!first) return table.malformed("the file is empty");
  const bool is_table = first->find_first_of(",;\t") != std::string::npos;
  if (is_table && !names_coordinate_system(*first)) return read_degrees(table, *first);
  HF_TRY(CoordinateSystem system, system_of_line(table, *first));
  const PositionColumns columns = columns_of_comments(table).value_or(PositionColumns{});
  return GeoTagReader(table, std::move(system), columns).read(std::nullopt);
}

TaggedPhotos apply_geo_tags(std::span<const GeoTag> tags, std::span<Photo> photos) {
  std::vector<std::string> names;
  for (const Photo& photo : photos) names.push_back(photo.metadata.name);
  const PhotoNames index(names);
  TaggedPhotos result;
  std::vector<const GeoTag*> tag_of(photos.size(), nullptr);
  for (const GeoTag& tag : tags) {
    if (const auto at = index.find(tag.photo)) {
      tag_of[*at] = &tag;
    } else {
      result.unknown.push_back(tag.photo);
    }
  }
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (tag_of[i] == nullptr) continue;
    const GeoTag& tag = *tag_of[i];
    PhotoMetadata& metadata = photos[i].metadata;
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
    ++result.num_tagged;
  }
  return result;
}

}  // namespace hybridfusion
