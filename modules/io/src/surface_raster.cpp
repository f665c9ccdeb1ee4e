#include <hybridfusion/io/surface_raster.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxCells = 1e8;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
};

[[nodiscard]] Eigen::Vector3d position_of(const PlacedCloud& placed, std::size_t i) {
  return placed.cloud.points[i].cast<double>() + placed.offset_m;
}

[[nodiscard]] Extent extent_of(const PlacedCloud& placed) {
  Extent extent;
  for (std::size_t i = 0; i < placed.cloud.size(); ++i) {
    const Eigen::Vector2d at = position_of(placed, i).head<2>();
    extent.low = extent.low.cwiseMin(at);
    extent.high = extent.high.cwiseMax(at);
  }
  return extent;
}

/// Sums of the cells around a gap.
struct Neighbours {
  int count = 0;
  float height_m = 0.0F;
  std::array<int, 3> color = {};
};

[[nodiscard]] Neighbours around(const SurfaceRaster& raster, int row, int column) {
  Neighbours sum;
  for (int r = std::max(0, row - 1); r <= std::min(raster.rows - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(raster.columns - 1, column + 1); ++c) {
      const std::size_t cell =
          static_cast<std::size_t>(r) * static_cast<std::size_t>(raster.columns) +
          static_cast<std::size_t>(c);
      if (std::isnan(raster.heights_m[cell])) continue;
      ++sum.count;
      sum.height_m += raster.heights_m[cell];
      if (raster.colors.empty()) continue;
      for (std::size_t k = 0; k < 3; ++k) sum.color[k] += raster.colors[cell][k];
    }
  }
  return sum;
}

/// Gives the gaps next to enough seen cells their mean; what is far from any stays empty.
void fill_once(SurfaceRaster& raster) {
  constexpr int kMinNeighbours = 3;
  const SurfaceRaster seen = raster;
  std::size_t cell = 0;
  for (int row = 0; row < raster.rows; ++row) {
    for (int column = 0; column < raster.columns; ++column, ++cell) {
      if (!std::isnan(seen.heights_m[cell])) continue;
      const Neighbours sum = around(seen, row, column);
      if (sum.count < kMinNeighbours) continue;
      raster.heights_m[cell] = sum.height_m / static_cast<float>(sum.count);
      if (raster.colors.empty()) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        raster.colors[cell][k] = static_cast<std::uint8_t>(sum.color[k] / sum.count);
      }
    }
  }
}

}  // namespace

Expected<SurfaceRaster> make_surface_raster(const PlacedCloud& placed,
                                            const SurfaceRasterOptions& options) {
  HF_CHECK(options.cell_m > 0.0 && options.fill_cells >= 0);
  const PointCloud& cloud = placed.cloud;
  if (cloud.empty()) return fail(ErrorCode::kInsufficient, "the cloud has no points to draw");
  const double cell_m = options.cell_m;
  const Extent extent = extent_of(placed);
  // Whole cells, so that rasters of neighbouring clouds fit together.
  const Eigen::Array2d first = (extent.low / cell_m).array().floor();
  const Eigen::Array2d last = (extent.high / cell_m).array().floor();
  const Eigen::Array2d cells = last - first + 1.0;
  if (!(cells.prod() <= kMaxCells)) {  // also NaN
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{:.0f} x {:.0f} cells of {} m are more than {:g}; take larger cells "
                            "or remove far points",
                            cells.x(),
                            cells.y(),
                            cell_m,
                            kMaxCells));
  }
  SurfaceRaster raster = {.columns = static_cast<int>(cells.x()),
                          .rows = static_cast<int>(cells.y()),
                          .cell_m = cell_m,
                          .north_west = {first.x() * cell_m, (last.y() + 1.0) * cell_m},
                          .wkt = placed.crs.wkt};
  raster.heights_m.assign(static_cast<std::size_t>(cells.prod()), kNothing);
  if (!cloud.colors.empty()) raster.colors.resize(raster.heights_m.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d at = position_of(placed, i);
    const auto column = static_cast<std::size_t>(std::floor(at.x() / cell_m) - first.x());
    const auto row = static_cast<std::size_t>(last.y() - std::floor(at.y() / cell_m));
    const std::size_t cell = row * static_cast<std::size_t>(raster.columns) + column;
    const auto height_m = static_cast<float>(at.z());
    if (height_m <= raster.heights_m[cell]) continue;  // false for an empty cell (NaN)
    raster.heights_m[cell] = height_m;
    if (!cloud.colors.empty()) raster.colors[cell] = cloud.colors[i];
  }
  for (int i = 0; i < options.fill_cells; ++i) fill_once(raster);
  return raster;
}

}  // namespace hybridfusion
