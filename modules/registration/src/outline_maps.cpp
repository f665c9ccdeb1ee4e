#include "outline_maps.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace hybridfusion {
namespace {

float percentile(std::vector<float>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

Raster edges_of(const Raster& height, double blur_m, const OutlineOptions& options) {
  Raster edge{height.grid, std::vector<float>(height.values.size(), 0.0F)};
  for (int y = 0; y < height.grid.height; ++y) {
    for (int x = 0; x < height.grid.width; ++x) {
      const float here = height.at(x, y);
      if (std::isnan(here)) continue;
      float lowest = here;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (!height.grid.contains(x + dx, y + dy)) continue;
          const float there = height.at(x + dx, y + dy);
          if (there < lowest) lowest = there;
        }
      }
      if (here - lowest > options.min_edge_m) edge.values[height.grid.index(x, y)] = 1.0F;
    }
  }
  blur(edge, blur_m);
  const auto gain =
      static_cast<float>(std::sqrt(2.0 * std::numbers::pi) * blur_m / height.grid.cell_m);
  for (float& value : edge.values) value = std::min(1.0F, gain * value);
  return edge;
}

/// Normals of facade cells from the 2D scatter of the facade cells around, and weights by shape.
void describe_facades(std::vector<FacadeCell>& facades,
                      const Raster& facade_index,
                      const Raster& is_free,
                      LidarMaps& maps) {
  const RasterGrid& grid = facade_index.grid;
  const int reach = static_cast<int>(std::lround(2.0 / grid.cell_m));
  double total = 0.0;
  double linear = 0.0;
  std::vector<double> factors(facades.size(), 1.0);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      if (facade_index.at(x, y) < 0.0F) continue;
      const auto self = static_cast<std::size_t>(facade_index.at(x, y));
      Eigen::Vector2d mean = Eigen::Vector2d::Zero();
      Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
      Eigen::Vector2d free_side = Eigen::Vector2d::Zero();
      int count = 0;
      for (int dy = -2 * reach; dy <= 2 * reach; ++dy) {
        for (int dx = -2 * reach; dx <= 2 * reach; ++dx) {
          if (!grid.contains(x + dx, y + dy)) continue;
          if (is_free.at(x + dx, y + dy) > 0.0F) free_side += Eigen::Vector2d(dx, dy);
          if (dx * dx + dy * dy > reach * reach || facade_index.at(x + dx, y + dy) < 0.0F) continue;
          const Eigen::Vector2d p =
              facades[static_cast<std::size_t>(facade_index.at(x + dx, y + dy))].mean.head<2>() -
              facades[self].mean.head<2>();
          mean += p;
          scatter += p * p.transpose();
          ++count;
        }
      }
      mean /= count;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter / count -
                                                                  mean * mean.transpose());
      const double narrow = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
      const double wide = std::sqrt(std::max(1e-12, solver.eigenvalues()[1]));
      total += facades[self].weight;
      if (count < 3) {
        factors[self] = 0.3;  // a pole or a stray column
      } else if (narrow > 0.35 * wide) {
        factors[self] = 0.4;  // a tree crown rather than a wall
      } else {
        linear += facades[self].weight;
        const Eigen::Vector2d normal = solver.eigenvectors().col(0);
        const double side = normal.dot(free_side);
        if (std::abs(side) > 1.0) facades[self].outward = side > 0.0 ? normal : -normal;
      }
    }
  }
  for (std::size_t i = 0; i < facades.size(); ++i) {
    facades[i].weight *= factors[i];
    maps.facade_weight += facades[i].weight;
  }
  maps.linear_share = total > 0.0 ? linear / total : 0.0;
}

}  // namespace

Box2 percentile_box(std::span<const Eigen::Vector3f> points, double share) {
  Box2 box;
  if (points.empty()) return box;
  std::vector<float> values(points.size());
  for (int axis = 0; axis < 2; ++axis) {
    std::ranges::transform(
        points, values.begin(), [&](const Eigen::Vector3f& p) { return p[axis]; });
    box.low[axis] = static_cast<double>(percentile(values, share));
    box.high[axis] = static_cast<double>(percentile(values, 1.0 - share));
  }
  return box;
}

VisionMaps make_vision_maps(std::span<const Eigen::Vector3f> points,
                            std::span<const float> heights,
                            double cell_m,
                            double blur_m,
                            const OutlineOptions& options) {
  const Box2 box = percentile_box(points, options.cut_share);
  const RasterGrid grid = grid_over(box.low, box.high, cell_m);
  const CellMembers cells = sort_into_cells(grid, points);
  VisionMaps maps;
  maps.height = {grid, std::vector<float>(grid.size(), kUnknown)};
  maps.ground_z = maps.height;
  std::vector<float> h;
  std::vector<float> z;
  for (std::size_t c = 0; c < grid.size(); ++c) {
    const auto members = cells.of(c);
    if (members.empty()) continue;
    h.clear();
    z.clear();
    for (const std::uint32_t i : members) {
      h.push_back(heights[i]);
      z.push_back(points[i].z());
    }
    maps.height.values[c] = percentile(h, 0.8);
    const auto [low, high] = std::ranges::minmax(h);
    const float middle = percentile(h, 0.5);
    if (std::abs(middle) < options.max_ground_m && high - low < options.max_ground_spread_m) {
      maps.ground_z.values[c] = percentile(z, 0.5);
    }
  }
  fill_small_holes(maps.height, 4, 2);
  maps.edge = edges_of(maps.height, blur_m, options);
  maps.interior = {grid, std::vector<float>(grid.size(), 0.0F)};
  for (std::size_t c = 0; c < grid.size(); ++c) {
    if (maps.height.values[c] > options.min_edge_m) maps.interior.values[c] = 1.0F;
  }
  erode(maps.interior, options.interior_margin_m);
  return maps;
}

LidarMaps make_lidar_maps(std::span<const Eigen::Vector3f> points,
                          std::span<const float> heights,
                          const OutlineOptions& options) {
  constexpr double kBin_m = 0.5;
  const Box2 box = percentile_box(points, options.cut_share);
  const RasterGrid grid = grid_over(box.low, box.high, options.lidar_cell_m);
  const CellMembers cells = sort_into_cells(grid, points);
  LidarMaps maps;
  Raster facade_index{grid, std::vector<float>(grid.size(), -1.0F)};
  Raster is_free{grid, std::vector<float>(grid.size(), 0.0F)};
  std::vector<float> z;
  for (std::size_t c = 0; c < grid.size(); ++c) {
    const auto members = cells.of(c);
    if (members.size() < 3) continue;
    std::uint64_t occupied = 0;
    Eigen::Vector3d high_mean = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    float low = heights[members.front()];
    float high = low;
    double num_high = 0.0;
    z.clear();
    for (const std::uint32_t i : members) {
      const double h = static_cast<double>(heights[i]);
      low = std::min(low, heights[i]);
      high = std::max(high, heights[i]);
      mean += points[i].cast<double>();
      z.push_back(points[i].z());
      if (h <= 1.0) continue;
      occupied |= std::uint64_t{1}
                  << std::min<std::uint64_t>(63, static_cast<std::uint64_t>((h - 1.0) / kBin_m));
      high_mean += points[i].cast<double>();
      num_high += 1.0;
    }
    const int bins = std::popcount(occupied);
    if (bins >= options.min_facade_bins) {
      facade_index.values[c] = static_cast<float>(maps.facades.size());
      maps.facades.push_back({.mean = high_mean / num_high, .weight = std::min(1.0, bins / 10.0)});
    } else if (std::max(std::abs(low), std::abs(high)) < options.max_ground_m &&
               high - low < options.max_free_spread_m) {
      is_free.values[c] = 1.0F;
      mean /= static_cast<double>(members.size());
      mean.z() = static_cast<double>(percentile(z, 0.5));
      maps.free_cells.push_back(mean);
    }
  }
  describe_facades(maps.facades, facade_index, is_free, maps);
  return maps;
}

}  // namespace hybridfusion
