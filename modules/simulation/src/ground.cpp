#include "terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kFarEdge_m = 200.0;

Surface ground_surface(Material material,
                       Eigen::Vector3f color,
                       float contrast,
                       std::uint64_t seed) {
  Surface surface{.material = material, .label = FaceLabel::kGround, .color = color};
  surface.contrast = contrast;
  surface.seed = static_cast<std::uint32_t>(seed * 977U) + static_cast<std::uint32_t>(material);
  return surface;
}

/// Grid lines: every kerb, at most 1 m apart in the built-up area, wider and wider outside.
std::vector<double> grid_lines(std::vector<double> stops, double half) {
  stops.insert(stops.end(), {-half, half});
  std::ranges::sort(stops);
  std::vector<double> lines;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const double length = stops[i + 1] - stops[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(length - 1e-9)));
    for (int part = 0; part < parts && length > 1e-6; ++part) {
      lines.push_back(stops[i] + length * part / parts);
    }
  }
  lines.push_back(half);
  double step = 1.5;
  for (double x = half; x < half + kFarEdge_m - 40.0; step = std::min(8.0, step * 1.15)) {
    x += step;
    lines.push_back(x);
    lines.push_back(-x);
  }
  std::ranges::sort(lines);
  return lines;
}

std::vector<double> kerb_lines(const StreetPlan& plan, const std::vector<double>& streets) {
  std::vector<double> lines;
  for (const double street : streets) {
    for (const double side : {-1.0, 1.0}) {
      lines.push_back(street + side * 0.5 * plan.street_width_m);
      lines.push_back(street + side * (0.5 * plan.street_width_m + plan.pavement_width_m));
    }
  }
  return lines;
}

struct GroundSurfaces {
  std::array<std::uint32_t, 4> by_kind = {};
  std::uint32_t kerb = 0;
  std::uint32_t paint = 0;
};

GroundSurfaces add_surfaces(const Terrain& terrain,
                            float contrast,
                            std::uint64_t seed,
                            MeshBuilder& builder) {
  const auto add =
      [&](Material material, Eigen::Vector3f color, Eigen::Vector2f cell, float reflectivity) {
        Surface surface = ground_surface(material, color, contrast, seed);
        surface.cell_m = cell;
        surface.lidar_reflectivity = reflectivity;
        return builder.add_surface(surface, terrain.frame());
      };
  GroundSurfaces surfaces;
  surfaces.by_kind = {add(Material::kAsphalt, {0.115F, 0.115F, 0.12F}, {1, 1}, 0.12F),
                      add(Material::kPavers, {0.36F, 0.35F, 0.34F}, {0.5F, 0.5F}, 0.3F),
                      add(Material::kCobble, {0.40F, 0.34F, 0.30F}, {0.55F, 0.38F}, 0.3F),
                      add(Material::kGrass, {0.16F, 0.20F, 0.07F}, {1, 1}, 0.4F)};
  surfaces.kerb = add(Material::kConcrete, {0.42F, 0.41F, 0.40F}, {1, 1}, 0.35F);
  surfaces.paint = add(Material::kRoadPaint, {0.62F, 0.62F, 0.60F}, {1, 1}, 0.7F);
  return surfaces;
}

void build_cells(const Terrain& terrain, const GroundSurfaces& surfaces, MeshBuilder& builder) {
  const StreetPlan& plan = terrain.plan();
  const auto lines_x = grid_lines(kerb_lines(plan, plan.street_x), plan.core_half_m.x());
  const auto lines_y = grid_lines(kerb_lines(plan, plan.street_y), plan.core_half_m.y());
  const GroundFrame frame = terrain.frame();
  const auto kind_of = [&](std::size_t i, std::size_t j) {
    return terrain.kind(0.5 * (lines_x[i] + lines_x[i + 1]), 0.5 * (lines_y[j] + lines_y[j + 1]));
  };
  const auto drop = [](GroundKind kind) { return kind == GroundKind::kRoad ? kKerbHeight_m : 0.0; };
  const auto at = [&](std::size_t i, std::size_t j, double below) -> Eigen::Vector3d {
    return frame *
           Eigen::Vector3d(lines_x[i], lines_y[j], terrain.height(lines_x[i], lines_y[j]) - below);
  };
  // A wall where the neighbour across the edge a-b lies lower or higher.
  const auto kerb = [&](std::size_t i0,
                        std::size_t j0,
                        std::size_t i1,
                        std::size_t j1,
                        GroundKind here,
                        GroundKind there) {
    const double d0 = drop(here);
    const double d1 = drop(there);
    if (d0 == d1) return;
    if (d0 > d1) {
      builder.quad(at(i0, j0, d0), at(i1, j1, d0), at(i1, j1, d1), at(i0, j0, d1), surfaces.kerb);
    } else {
      builder.quad(at(i1, j1, d1), at(i0, j0, d1), at(i0, j0, d0), at(i1, j1, d0), surfaces.kerb);
    }
  };
  for (std::size_t j = 0; j + 1 < lines_y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < lines_x.size(); ++i) {
      const GroundKind kind = kind_of(i, j);
      const double below = drop(kind);
      const std::uint32_t surface = surfaces.by_kind[static_cast<std::size_t>(kind)];
      builder.triangle(at(i, j, below), at(i + 1, j, below), at(i + 1, j + 1, below), surface);
      builder.triangle(at(i, j, below), at(i + 1, j + 1, below), at(i, j + 1, below), surface);
      if (i + 2 < lines_x.size()) kerb(i + 1, j + 1, i + 1, j, kind, kind_of(i + 1, j));
      if (j + 2 < lines_y.size()) kerb(i, j + 1, i + 1, j + 1, kind, kind_of(i, j + 1));
    }
  }
}

/// Paint on the road: rectangle of the block frame, draped over the ground.
void paint_rectangle(const Terrain& terrain,
                     std::uint32_t surface,
                     Eigen::Vector2d low,
                     Eigen::Vector2d high,
                     MeshBuilder& builder) {
  constexpr double kPaintLift_m = 0.006;
  const Eigen::Vector2d size = high - low;
  const int nx = std::max(1, static_cast<int>(std::ceil(size.x())));
  const int ny = std::max(1, static_cast<int>(std::ceil(size.y())));
  const auto at = [&](int i, int j) -> Eigen::Vector3d {
    const double x = low.x() + size.x() * i / nx;
    const double y = low.y() + size.y() * j / ny;
    return terrain.frame() *
           Eigen::Vector3d(x, y, terrain.height(x, y) - kKerbHeight_m + kPaintLift_m);
  };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), surface);
    }
  }
}

/// Markings of one street piece between two crossings; `along_x` says which way it runs.
void paint_street(const Terrain& terrain,
                  std::uint32_t paint,
                  bool along_x,
                  double center,
                  double from,
                  double to,
                  MeshBuilder& builder) {
  const double half = 0.5 * terrain.plan().street_width_m;
  const auto stripe = [&](double s0, double s1, double t0, double t1) {
    const Eigen::Vector2d low =
        along_x ? Eigen::Vector2d(s0, center + t0) : Eigen::Vector2d(center + t0, s0);
    const Eigen::Vector2d high =
        along_x ? Eigen::Vector2d(s1, center + t1) : Eigen::Vector2d(center + t1, s1);
    paint_rectangle(terrain, paint, low, high, builder);
  };
  for (double s = from + 5.5; s + 2.0 < to - 5.0; s += 4.5) stripe(s, s + 2.0, -0.07, 0.07);
  for (const double s : {from + 1.2, to - 3.9}) {
    for (double t = -half + 0.4; t + 0.5 < half - 0.2; t += 1.0) stripe(s, s + 2.7, t, t + 0.5);
  }
  for (double s = from + 6.0; s < to - 5.5; s += 6.0) stripe(s, s + 0.1, half - 2.3, half - 0.1);
  stripe(from + 6.0, to - 6.0, half - 2.4, half - 2.3);
}

}  // namespace

void build_ground(const Terrain& terrain,
                  float contrast,
                  std::uint64_t seed,
                  MeshBuilder& builder) {
  const GroundSurfaces surfaces = add_surfaces(terrain, contrast, seed, builder);
  build_cells(terrain, surfaces, builder);
  const StreetPlan& plan = terrain.plan();
  if (!plan.streets) return;
  const double half = 0.5 * plan.street_width_m;
  const auto paint_all =
      [&](bool along_x, const std::vector<double>& centers, const std::vector<double>& crossings) {
        for (const double center : centers) {
          for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            paint_street(terrain,
                         surfaces.paint,
                         along_x,
                         center,
                         crossings[i] + half,
                         crossings[i + 1] - half,
                         builder);
          }
        }
      };
  paint_all(true, plan.street_y, plan.street_x);
  paint_all(false, plan.street_x, plan.street_y);
}

}  // namespace hybridfusion
