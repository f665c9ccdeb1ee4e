#include "chart.hpp"
#include "html.hpp"
#include "plan_map.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// What lies above a cell of the ground.
struct Cell {
  std::vector<float> vision_m = {};  ///< Heights.
  std::vector<float> lidar_m = {};
};

struct CellMap {
  Eigen::AlignedBox2d box = {};
  double side_m = 1.0;
  int columns = 0;
  int rows = 0;
  std::vector<Cell> cells = {};

  [[nodiscard]] Cell* at(const Eigen::Vector3f& point) {
    const auto x = static_cast<int>(std::floor((point.x() - box.min().x()) / side_m));
    const auto y = static_cast<int>(std::floor((point.y() - box.min().y()) / side_m));
    if (x < 0 || y < 0 || x >= columns || y >= rows) return nullptr;
    return &cells[static_cast<std::size_t>(y) * columns + x];
  }
  [[nodiscard]] Eigen::Vector2d corner(std::size_t index) const {
    return box.min() + side_m * Eigen::Vector2d(static_cast<double>(index % columns),
                                                static_cast<double>(index / columns));
  }
};

CellMap cells_of(const PointCloud& vision, const PointCloud& lidar) {
  constexpr double kMostCells = 150.0;  // a side; the page stays small
  CellMap map{.box = trimmed_box(lidar.points, 0.005, 3.0)};
  map.side_m = std::max(0.5, map.box.sizes().maxCoeff() / kMostCells);
  map.columns = static_cast<int>(std::ceil(map.box.sizes().x() / map.side_m));
  map.rows = static_cast<int>(std::ceil(map.box.sizes().y() / map.side_m));
  map.cells.resize(static_cast<std::size_t>(map.columns) * map.rows);
  for (const Eigen::Vector3f& point : vision.points) {
    if (Cell* cell = map.at(point)) cell->vision_m.push_back(point.z());
  }
  for (const Eigen::Vector3f& point : lidar.points) {
    if (Cell* cell = map.at(point)) cell->lidar_m.push_back(point.z());
  }
  return map;
}

Figure coverage_figure(const CellMap& map) {
  PlanMap plan(map.box, 620.0);
  std::array<std::size_t, 3> counts{};
  constexpr std::size_t kMinPoints = 2;  // a single stray point covers nothing
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const bool vision = map.cells[i].vision_m.size() >= kMinPoints;
    const bool lidar = map.cells[i].lidar_m.size() >= kMinPoints;
    if (!vision && !lidar) continue;
    const std::size_t kind = vision && lidar ? 2 : lidar ? 1 : 0;
    ++counts[kind];
    plan.square(map.corner(i),
                map.side_m,
                kind == 2   ? "#7dbb8e"
                : kind == 1 ? "#e59a5c"
                            : "#9cc3e4");
  }
  const double cell_m2 = map.side_m * map.side_m;
  const auto area = [&](std::size_t kind) { return static_cast<double>(counts[kind]) * cell_m2; };
  return {
      .id = "overlap-map",
      .title = "Overlap of the two clouds",
      .body = plan.svg() +
              "<p class=keys><span><i style='background:#7dbb8e'></i>both</span> "
              "<span><i style='background:#9cc3e4'></i>photos only</span> "
              "<span><i style='background:#e59a5c'></i>LiDAR only</span></p>\n",
      .caption = fmt::format(
          "Cells of {:.1f} m in the rectangle of the LiDAR cloud: {:.0f} m² seen by both, {:.0f} "
          "m² by the photos only, {:.0f} m² by the LiDAR only.",
          map.side_m,
          area(2),
          area(0),
          area(1)),
      .sources = {workspace_file::kDense, workspace_file::kMap, workspace_file::kRegistration}};
}

double lower_edge(std::vector<float>& heights) {
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
  std::ranges::nth_element(heights, at);
  return *at;
}

std::optional<Figure> change_figure(CellMap& map) {
  constexpr double kMost_m = 0.5;
  constexpr std::size_t kMinPoints = 4;
  PlanMap plan(map.box, 620.0);
  std::vector<double> differences_m;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    Cell& cell = map.cells[i];
    if (cell.vision_m.size() < kMinPoints || cell.lidar_m.size() < kMinPoints) continue;
    const double difference_m = lower_edge(cell.lidar_m) - lower_edge(cell.vision_m);
    differences_m.push_back(difference_m);
    plan.square(map.corner(i), map.side_m, ramp_color(0.5 + 0.5 * difference_m / kMost_m));
  }
  if (differences_m.empty()) return std::nullopt;
  std::vector<double> sizes_m;
  for (const double difference_m : differences_m) sizes_m.push_back(std::abs(difference_m));
  return Figure{
      .id = "change-map",
      .title = "Height differences and changes",
      .body = plan.svg() + ramp_legend(fmt::format("LiDAR {} m lower", kMost_m),
                                       fmt::format("{} m higher", kMost_m)),
      .caption = fmt::format(
          "Lower edge of the LiDAR cloud less that of the photos' cloud in cells of {:.1f} m; "
          "median "
          "{:+.3f} m, median size {:.3f} m. Green is agreement. Blue beside facades and under "
          "trees "
          "is ground that the drone did not see; a coloured patch on open ground is a change "
          "between the two recordings, a slope over the whole map a tilt.",
          map.side_m,
          quantile(differences_m, 0.5),
          quantile(sizes_m, 0.5)),
      .sources = {workspace_file::kDense, workspace_file::kMap, workspace_file::kRegistration}};
}

}  // namespace

std::vector<Figure> overlap_figures(const ReportData& data) {
  std::vector<Figure> figures;
  if (!data.registered() || data.vision.empty() || data.lidar.empty()) return figures;
  const PointCloud lidar =
      transformed(data.shown_from_lidar(), PointCloud{.points = data.lidar.points});
  CellMap map = cells_of(data.vision, lidar);
  figures.push_back(coverage_figure(map));
  if (auto figure = change_figure(map)) figures.push_back(*std::move(figure));
  return figures;
}

}  // namespace hybridfusion
