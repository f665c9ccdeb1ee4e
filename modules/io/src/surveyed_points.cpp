#include "coordinate_checks.hpp"
#include "coordinate_system.hpp"
#include "coordinate_table.hpp"
#include "text.hpp"

#include <hybridfusion/io/geo_tags.hpp>

#include <array>
#include <unordered_map>

#include <fmt/format.h>

namespace hybridfusion {

Expected<SurveyFile> read_surveyed_points(const std::filesystem::path& path) {
  constexpr double kCorner_px = 0.5;  // pixels counted from the corner of the first one
  constexpr std::size_t kNumbers = 5;
  constexpr double kSame = 0.02;  // what a survey is good for
  HF_TRY(CoordinateTable table, CoordinateTable::open(path));
  HF_TRY(const auto first, table.next());
  if (!first) return table.malformed("the file is empty");
  HF_TRY(const CoordinateSystem system, system_of_line(table, *first));
  SurveyFile file{.system = system.text(),
                  .metres_per_height_unit = system.metres_per_height_unit()};
  std::vector<Eigen::Vector3d> written;
  std::vector<GeodeticPosition> positions;
  std::unordered_map<std::string, std::size_t> index;
  for (bool heading = true;; heading = false) {
    HF_TRY(const auto line, table.next());
    if (!line) break;
    const auto row = row_of(*line, kNumbers);
    if (heading && row && !finite_field(row->before, 0) && !finite_field(row->before, 1)) continue;
    std::array<double, kNumbers> numbers{};
    for (std::size_t k = 0; k < kNumbers; ++k) {
      const auto number = row ? finite_field(row->before, k) : std::nullopt;
      if (!number && k == 2 && row && lower_case(row->before[k]) == "nan") {
        return table.malformed("the point has no height (NaN), which is needed here");
      }
      if (!number) return table.malformed("not x y z, pixel x, pixel y and a photo name");
      numbers[k] = *number;
    }
    if (row->photo.empty()) return table.malformed("the photo name is missing");
    const std::string name =
        !row->after.empty() && !row->after.front().empty()
            ? row->after.front()
            : fmt::format("{} {} {}", row->before[0], row->before[1], row->before[2]);
    const Eigen::Vector3d at(numbers[0], numbers[1], numbers[2]);
    const auto [known, fresh] = index.try_emplace(name, file.points.size());
    if (fresh) {
      const auto position = system(at);
      if (!position || !on_earth(*position)) {
        return table.malformed("the coordinates lie outside the coordinate system" +
                               hint_of(at, system));
      }
      written.push_back(at);
      positions.push_back(*position);
      file.points.push_back({.name = name, .position = *position, .written = at});
    } else if ((file.points[known->second].written - at).norm() > kSame) {
      return table.malformed(fmt::format("point {} has other coordinates than before", name));
    }
    file.points[known->second].marks.push_back(
        {.photo = row->photo, .pixel = {numbers[3] - kCorner_px, numbers[4] - kCorner_px}});
  }
  if (auto checked = check_written(table, system, written, positions, file.notes); !checked) {
    return std::unexpected(checked.error());
  }
  return file;
}

}  // namespace hybridfusion
