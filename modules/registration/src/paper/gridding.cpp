#include "outline_maps.hpp"
#include "raster.hpp"

#include <hybridfusion/registration/gridding.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxCells = 1e6;

Patch make_patch(std::span<const Eigen::Vector3f> points,
                 std::span<const std::uint32_t> members,
                 const Eigen::Vector2i& cell) {
  Patch patch{.cell = cell, .indices = {members.begin(), members.end()}};
  for (const std::uint32_t i : members) patch.centroid += points[i].cast<double>();
  patch.centroid /= static_cast<double>(members.size());
  return patch;
}

}  // namespace

int PatchGrid::patch_at(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns || row >= rows) return -1;
  return patch_of[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
}

double scene_size_m(std::span<const Eigen::Vector3f> points, double cut_share) {
  const Box2 box = percentile_box(points, cut_share);
  return (box.high - box.low).maxCoeff();
}

Expected<PatchGrid> grid_into_patches(std::span<const Eigen::Vector3f> points,
                                      double step_m,
                                      double cut_share,
                                      const Eigen::Vector2d& shift) {
  HF_CHECK(step_m > 0.0);
  if (points.empty())
    return fail(ErrorCode::kInsufficient, "a cloud without points has no patches");
  const Box2 box = percentile_box(points, cut_share);
  const Eigen::Vector2d cells = (box.high - box.low) / step_m;
  if (!((cells.x() + 2.0) * (cells.y() + 2.0) <= kMaxCells)) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("a patch step of {:.3g} m would cut the scene of {:.3g} x {:.3g} m into "
                    "more than {:.0g} patches; use a larger step",
                    step_m,
                    box.high.x() - box.low.x(),
                    box.high.y() - box.low.y(),
                    kMaxCells));
  }
  const RasterGrid raster = grid_over(box.low - step_m * shift, box.high, step_m);
  const CellMembers members = sort_into_cells(raster, points);
  PatchGrid grid{.origin = raster.origin,
                 .step_m = step_m,
                 .columns = raster.width,
                 .rows = raster.height,
                 .patch_of = std::vector<int>(raster.size(), -1)};
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const std::size_t cell = raster.index(column, row);
      if (members.of(cell).empty()) continue;
      grid.patch_of[cell] = static_cast<int>(grid.patches.size());
      grid.patches.push_back(make_patch(points, members.of(cell), {column, row}));
    }
  }
  return grid;
}

std::vector<std::size_t> neighbours_of(const PatchGrid& grid,
                                       std::size_t patch,
                                       std::size_t min_points) {
  const Eigen::Vector2i cell = grid.patches[patch].cell;
  std::vector<std::size_t> neighbours;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int other = grid.patch_at(cell.x() + dx, cell.y() + dy);
      if (other < 0 || static_cast<std::size_t>(other) == patch) continue;
      if (grid.patches[static_cast<std::size_t>(other)].indices.size() < min_points) continue;
      neighbours.push_back(static_cast<std::size_t>(other));
    }
  }
  return neighbours;
}

std::vector<std::uint32_t> splice_neighbours(const PatchGrid& grid, std::size_t patch) {
  const Eigen::Vector2i cell = grid.patches[patch].cell;
  std::vector<std::uint32_t> indices;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int other = grid.patch_at(cell.x() + dx, cell.y() + dy);
      if (other < 0) continue;
      const auto& more = grid.patches[static_cast<std::size_t>(other)].indices;
      indices.insert(indices.end(), more.begin(), more.end());
    }
  }
  return indices;
}

}  // namespace hybridfusion
