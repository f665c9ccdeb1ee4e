#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// A 2D grid of square cells in the x-y plane; `origin` is the outer corner of cell (0, 0).
struct RasterGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< [m]
  double cell_m = 1.0;
  int width = 0;
  int height = 0;

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height;
  }
  [[nodiscard]] Eigen::Vector2d centre_of(int x, int y) const {
    return origin + cell_m * Eigen::Vector2d(x + 0.5, y + 0.5);
  }
};

/// The smallest grid over the box [low, high].
[[nodiscard]] RasterGrid grid_over(const Eigen::Vector2d& low,
                                   const Eigen::Vector2d& high,
                                   double cell_m);

struct Raster {
  RasterGrid grid = {};
  std::vector<float> values = {};  ///< Row-major; kUnknown where nothing is known.

  [[nodiscard]] float at(int x, int y) const { return values[grid.index(x, y)]; }
  /// Bilinear between cell centres; cells outside count as 0. @pre no unknown values
  [[nodiscard]] float sample(double x, double y) const {
    const double u = (x - grid.origin.x()) / grid.cell_m - 0.5;
    const double v = (y - grid.origin.y()) / grid.cell_m - 0.5;
    if (!(u > -1.0 && v > -1.0 && u < grid.width && v < grid.height)) return 0.0F;
    const int x0 = static_cast<int>(u + 1.0) - 1;
    const int y0 = static_cast<int>(v + 1.0) - 1;
    const auto fx = static_cast<float>(u - x0);
    const auto fy = static_cast<float>(v - y0);
    const auto get = [&](int cx, int cy) { return grid.contains(cx, cy) ? at(cx, cy) : 0.0F; };
    return (1.0F - fy) * ((1.0F - fx) * get(x0, y0) + fx * get(x0 + 1, y0)) +
           fy * ((1.0F - fx) * get(x0, y0 + 1) + fx * get(x0 + 1, y0 + 1));
  }
  /// The value of the cell that holds (x, y); kUnknown outside.
  [[nodiscard]] float nearest(double x, double y) const {
    const int cx = static_cast<int>(std::floor((x - grid.origin.x()) / grid.cell_m));
    const int cy = static_cast<int>(std::floor((y - grid.origin.y()) / grid.cell_m));
    return grid.contains(cx, cy) ? at(cx, cy) : kUnknown;
  }
};

/// Points sorted into cells: members of cell c are indices[begin[c]] .. indices[begin[c + 1] - 1],
/// ascending. Points outside the grid are left out.
struct CellMembers {
  std::vector<std::uint32_t> begin = {};
  std::vector<std::uint32_t> indices = {};

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t cell) const {
    return std::span(indices).subspan(begin[cell], begin[cell + 1] - begin[cell]);
  }
};
[[nodiscard]] CellMembers sort_into_cells(const RasterGrid& grid,
                                          std::span<const Eigen::Vector3f> points);

/// Unknown cells with at least `min_known` known ones among their 8 neighbours take the median of
/// these; `rounds` times.
void fill_small_holes(Raster& raster, int min_known, int rounds);

/// The raster at twice the cell: means of 2 x 2 cells, cells beyond the edge counting as 0.
/// @pre no unknown values
[[nodiscard]] Raster halved(const Raster& raster);

/// Gaussian blur, zero outside. @pre no unknown values
void blur(Raster& raster, double sigma_m);

/// Keeps the non-zero cells whose disc of `radius_m` has no known zero cell. @pre no unknown values
void erode(Raster& raster, double radius_m);

}  // namespace hybridfusion
