#include "raster.hpp"

#include <algorithm>

namespace hybridfusion {

RasterGrid grid_over(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell_m) {
  const Eigen::Vector2i size = ((high - low) / cell_m).array().floor().cast<int>() + 1;
  return {.origin = low, .cell_m = cell_m, .width = size.x(), .height = size.y()};
}

CellMembers sort_into_cells(const RasterGrid& grid, std::span<const Eigen::Vector3f> points) {
  constexpr auto kOutside = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> cell_of(points.size(), kOutside);
  CellMembers cells;
  cells.begin.assign(grid.size() + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d offset = (points[i].head<2>().cast<double>() - grid.origin) / grid.cell_m;
    const int x = static_cast<int>(std::floor(offset.x()));
    const int y = static_cast<int>(std::floor(offset.y()));
    if (!grid.contains(x, y)) continue;
    cell_of[i] = static_cast<std::uint32_t>(grid.index(x, y));
    ++cells.begin[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < cells.begin.size(); ++c) cells.begin[c] += cells.begin[c - 1];
  cells.indices.resize(cells.begin.back());
  std::vector<std::uint32_t> next(cells.begin.begin(), cells.begin.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (cell_of[i] != kOutside) cells.indices[next[cell_of[i]]++] = static_cast<std::uint32_t>(i);
  }
  return cells;
}

void fill_small_holes(Raster& raster, int min_known, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const Raster before = raster;
    std::vector<float> known;
    for (int y = 0; y < raster.grid.height; ++y) {
      for (int x = 0; x < raster.grid.width; ++x) {
        if (!std::isnan(before.at(x, y))) continue;
        known.clear();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (!raster.grid.contains(x + dx, y + dy)) continue;
            const float value = before.at(x + dx, y + dy);
            if (!std::isnan(value)) known.push_back(value);
          }
        }
        if (known.size() < static_cast<std::size_t>(min_known)) continue;
        std::ranges::sort(known);
        raster.values[raster.grid.index(x, y)] = known[known.size() / 2];
      }
    }
  }
}

Raster halved(const Raster& raster) {
  Raster result{.grid = {.origin = raster.grid.origin,
                         .cell_m = 2.0 * raster.grid.cell_m,
                         .width = (raster.grid.width + 1) / 2,
                         .height = (raster.grid.height + 1) / 2}};
  result.values.assign(result.grid.size(), 0.0F);
  for (int y = 0; y < raster.grid.height; ++y) {
    for (int x = 0; x < raster.grid.width; ++x) {
      result.values[result.grid.index(x / 2, y / 2)] += 0.25F * raster.at(x, y);
    }
  }
  return result;
}

void blur(Raster& raster, double sigma_m) {
  const double sigma = sigma_m / raster.grid.cell_m;
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int k = -reach; k <= reach; ++k) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma))));
    sum += kernel.back();
  }
  for (float& weight : kernel) weight /= sum;
  const int width = raster.grid.width;
  const int height = raster.grid.height;
  std::vector<float> rows(raster.values.size(), 0.0F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float value = raster.at(x, y);
      if (value == 0.0F) continue;
      for (int k = std::max(-reach, -x); k <= std::min(reach, width - 1 - x); ++k) {
        rows[raster.grid.index(x + k, y)] += value * kernel[static_cast<std::size_t>(k + reach)];
      }
    }
  }
  std::ranges::fill(raster.values, 0.0F);
  for (int y = 0; y < height; ++y) {
    for (int k = std::max(-reach, -y); k <= std::min(reach, height - 1 - y); ++k) {
      const float weight = kernel[static_cast<std::size_t>(k + reach)];
      const float* source = &rows[raster.grid.index(0, y)];
      float* target = &raster.values[raster.grid.index(0, y + k)];
      for (int x = 0; x < width; ++x) target[x] += weight * source[x];
    }
  }
}

void erode(Raster& raster, double radius_m) {
  const Raster before = raster;
  const double radius = radius_m / raster.grid.cell_m;
  const int reach = static_cast<int>(radius);
  for (int y = 0; y < raster.grid.height; ++y) {
    for (int x = 0; x < raster.grid.width; ++x) {
      if (before.at(x, y) == 0.0F) continue;
      bool is_inside = true;
      for (int dy = -reach; is_inside && dy <= reach; ++dy) {
        for (int dx = -reach; is_inside && dx <= reach; ++dx) {
          if (dx * dx + dy * dy > radius * radius) continue;
          is_inside = !raster.grid.contains(x + dx, y + dy) || before.at(x + dx, y + dy) != 0.0F;
        }
      }
      if (!is_inside) raster.values[raster.grid.index(x, y)] = 0.0F;
    }
  }
}

}  // namespace hybridfusion
