#include <hybridfusion/io/surface_raster.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kMaxCells = 1e8;
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

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

void SurfaceExtent::add(const PointCloud& cloud, const Eigen::Vector3d& offset_m) {
  for (const Eigen::Vector3f& point : cloud.points) {
    const Eigen::Array2d at = (point.cast<double>() + offset_m).head<2>();
    low = low.min(at);
    high = high.max(at);
  }
}

Expected<SurfaceRasterBuilder> SurfaceRasterBuilder::create(const SurfaceExtent& extent,
                                                            const SurfaceRasterOptions& options) {
  HF_CHECK(options.cell_m > 0.0 && options.fill_cells >= 0);
  if (extent.low.x() > extent.high.x()) {
    return fail(ErrorCode::kInsufficient, "the cloud has no points to draw");
  }
  SurfaceRasterBuilder builder(options);
  const double cell_m = options.cell_m;
  // Whole cells, so that rasters of neighbouring clouds fit together.
  builder.first_ = (extent.low / cell_m).floor();
  builder.last_ = (extent.high / cell_m).floor();
  const Eigen::Array2d cells = builder.last_ - builder.first_ + 1.0;
  if (!(cells.prod() <= kMaxCells)) {  // also NaN
    return fail(ErrorCode::kInvalidOptions,
                fmt::format("{:.0f} x {:.0f} cells of {} m are more than {:g}; take larger cells "
                            "or remove far points",
                            cells.x(),
                            cells.y(),
                            cell_m,
                            kMaxCells));
  }
  builder.raster_ = {
      .columns = static_cast<int>(cells.x()),
      .rows = static_cast<int>(cells.y()),
      .cell_m = cell_m,
      .north_west = {builder.first_.x() * cell_m, (builder.last_.y() + 1.0) * cell_m}};
  builder.raster_.heights_m.assign(static_cast<std::size_t>(cells.prod()), kNothing);
  return builder;
}

void SurfaceRasterBuilder::add(const PointCloud& cloud, const Eigen::Vector3d& offset_m) {
  if (!cloud.colors.empty()) raster_.colors.resize(raster_.heights_m.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d at = cloud.points[i].cast<double>() + offset_m;
    const auto column = static_cast<std::size_t>(std::floor(at.x() / raster_.cell_m) - first_.x());
    const auto row = static_cast<std::size_t>(last_.y() - std::floor(at.y() / raster_.cell_m));
    const std::size_t cell = row * static_cast<std::size_t>(raster_.columns) + column;
    const auto height_m = static_cast<float>(at.z());
    if (height_m <= raster_.heights_m[cell]) continue;  // false for an empty cell (NaN)
    raster_.heights_m[cell] = height_m;
    if (!cloud.colors.empty()) raster_.colors[cell] = cloud.colors[i];
  }
}

SurfaceRaster SurfaceRasterBuilder::finish(const CrsDescription& crs) && {
  raster_.wkt = crs.wkt;
  if (!crs.wkt.empty()) {
    raster_.metres_per_unit = crs.metres_per_unit;
    raster_.vertical_metres_per_unit = crs.vertical_metres_per_unit;
  }
  for (int i = 0; i < options_.fill_cells; ++i) fill_once(raster_);
  return std::move(raster_);
}

Expected<SurfaceRaster> make_surface_raster(const PlacedCloud& placed,
                                            const SurfaceRasterOptions& options) {
  SurfaceExtent extent;
  extent.add(placed.cloud, placed.offset_m);
  HF_TRY(SurfaceRasterBuilder builder, SurfaceRasterBuilder::create(extent, options));
  builder.add(placed.cloud, placed.offset_m);
  return std::move(builder).finish(placed.crs);
}

}  // namespace hybridfusion
