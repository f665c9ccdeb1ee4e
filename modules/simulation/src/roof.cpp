#include "building.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr double kParapetThickness_m = 0.28;

/// Boxes and pipes that stand on flat roofs.
void build_roof_clutter(const BuildingStyle& style,
                        const BuildingSurfaces& surfaces,
                        const GroundFrame& frame,
                        const PlanRectangle& area,
                        double roof_m,
                        Random& random,
                        MeshBuilder& builder) {
  const Eigen::Vector2d size = area.high - area.low;
  const int count = static_cast<int>(size.prod() / 45.0 + 2.0 * random.uniform());
  for (int i = 0; i < count; ++i) {
    const double w = random.uniform(0.8, 2.4);
    const double d = random.uniform(0.8, 1.8);
    const double h = random.uniform(0.5, 1.6);
    if (size.x() < w + 1.6 || size.y() < d + 1.6) continue;
    const double x = random.uniform(area.low.x() + 0.8, area.high.x() - w - 0.8);
    const double y = random.uniform(area.low.y() + 0.8, area.high.y() - d - 0.8);
    builder.box(frame,
                {x, y, roof_m},
                {x + w, y + d, roof_m + h},
                random.uniform() < 0.5 ? surfaces.metal : surfaces.trim,
                16);
    if (random.uniform() < 0.4) {
      const Eigen::Vector3d foot = frame * Eigen::Vector3d(x + w + 0.4, y, roof_m);
      builder.tube(foot,
                   foot + Eigen::Vector3d(0, 0, random.uniform(0.8, 2.2)),
                   0.07,
                   0.07,
                   6,
                   surfaces.metal);
    }
  }
  (void)style;
}

void build_flat_roof(const BuildingStyle& style,
                     const BuildingSurfaces& surfaces,
                     const GroundFrame& frame,
                     const std::vector<PlanRectangle>& rectangles,
                     const std::vector<WallPiece>& walls,
                     MeshBuilder& builder) {
  Random random(style.seed, "world/roof");
  const double roof = style.floors * style.floor_height_m;
  for (const PlanRectangle& r : rectangles) {
    const auto at = [&](double x, double y) -> Eigen::Vector3d {
      return frame * Eigen::Vector3d(x, y, roof);
    };
    builder.quad(at(r.low.x(), r.low.y()),
                 at(r.high.x(), r.low.y()),
                 at(r.high.x(), r.high.y()),
                 at(r.low.x(), r.high.y()),
                 surfaces.roof);
    build_roof_clutter(style, surfaces, frame, r, roof, random, builder);
  }
  for (const WallPiece& wall : walls) {
    const Eigen::Vector2d along = wall.right - wall.left;
    const GroundFrame edge =
        frame.at({wall.left.x(), wall.left.y(), roof}, std::atan2(along.y(), along.x()));
    const double length = along.norm();
    const double cap = style.parapet_m - 0.1;
    builder.box(edge, {0.0, 0.0, 0.0}, {length, kParapetThickness_m, cap}, surfaces.wall, 16 | 32);
    builder.box(edge,
                {-0.04, -0.05, cap},
                {length + 0.04, kParapetThickness_m + 0.05, cap + 0.1},
                surfaces.trim);
  }
}

/// Two slopes over a box, ridge along the longer side (local x after the caller's turn).
void build_gable_roof(const BuildingStyle& style,
                      const BuildingSurfaces& surfaces,
                      const GroundFrame& frame,
                      const PlanRectangle& r,
                      MeshBuilder& builder) {
  Random random(style.seed, "world/roof");
  const double wall_top = style.floors * style.floor_height_m;
  const double half = 0.5 * (r.high.y() - r.low.y());
  const double rise = half * style.roof_pitch;
  const double out = style.eaves_m;
  const double x0 = r.low.x();
  const double x1 = r.high.x();
  const bool hip = style.roof == RoofShape::kHip;
  const double inset = hip ? std::min(half, 0.45 * (x1 - x0)) : 0.0;
  const auto at = [&](double x, double y, double z) -> Eigen::Vector3d {
    return frame * Eigen::Vector3d(x, y, wall_top + z);
  };
  const double drop = out * style.roof_pitch;
  const double thick = 0.22;
  const double e0 = x0 - out;
  const double e1 = x1 + out;
  const double ridge0 = hip ? x0 + inset : e0;
  const double ridge1 = hip ? x1 - inset : e1;
  for (const double side : {-1.0, 1.0}) {
    const double y = side * (half + out);
    const double a = side < 0 ? e0 : e1;
    const double b = side < 0 ? e1 : e0;
    const double ra = side < 0 ? ridge0 : ridge1;
    const double rb = side < 0 ? ridge1 : ridge0;
    builder.quad(at(a, y, thick - drop),
                 at(b, y, thick - drop),
                 at(rb, 0, rise + thick),
                 at(ra, 0, rise + thick),
                 surfaces.roof);
    builder.quad(at(a, y, -drop),
                 at(b, y, -drop),
                 at(b, y, thick - drop),
                 at(a, y, thick - drop),
                 surfaces.trim);
    builder.quad(at(b, y, -drop),
                 at(a, y, -drop),
                 at(a, side * half, 0),
                 at(b, side * half, 0),
                 surfaces.trim);
  }
  for (const double side : {-1.0, 1.0}) {
    const double x = side < 0 ? x0 : x1;
    const double e = side < 0 ? e0 : e1;
    const double y = side * (half + out);
    if (hip) {
      const double top = side < 0 ? ridge0 : ridge1;
      const Eigen::Vector3d apex = at(top, 0, rise + thick);
      builder.quad(at(e, -y, thick - drop), at(e, y, thick - drop), apex, apex, surfaces.roof);
      builder.quad(at(e, -y, -drop),
                   at(e, y, -drop),
                   at(e, y, thick - drop),
                   at(e, -y, thick - drop),
                   surfaces.trim);
      builder.quad(at(e, y, -drop),
                   at(e, -y, -drop),
                   at(x, -side * half, 0),
                   at(x, side * half, 0),
                   surfaces.trim);
      continue;
    }
    builder.quad(at(x, -side * half, 0),
                 at(x, side * half, 0),
                 at(x, 0, rise),
                 at(x, 0, rise),
                 surfaces.wall);
    for (const double wing : {-1.0, 1.0}) {
      const Eigen::Vector3d low = at(e, wing * (half + out), -drop);
      const Eigen::Vector3d high = at(e, 0, rise);
      const Eigen::Vector3d lift(0, 0, thick);
      if (wing * side > 0) {
        builder.quad(low, low + lift, high + lift, high, surfaces.trim);
      } else {
        builder.quad(high, high + lift, low + lift, low, surfaces.trim);
      }
      const Eigen::Vector3d wall_low = at(x, wing * (half + out), -drop);
      const Eigen::Vector3d wall_high = at(x, 0, rise);
      builder.quad(low, wall_low, wall_high, high, surfaces.trim);
    }
  }
  const double chimney_x = random.uniform(x0 + 1.0, x1 - 1.0);
  const double chimney_y = random.uniform(-0.5, 0.5) * half;
  builder.box(frame,
              {chimney_x - 0.4, chimney_y - 0.35, wall_top},
              {chimney_x + 0.4, chimney_y + 0.35, wall_top + rise + 1.1},
              surfaces.trim,
              16);
  // Roof lights lie a hand above the tiles.
  const int lights = static_cast<int>(random.uniform(1.0, 4.0));
  for (int i = 0; i < lights && !hip; ++i) {
    const double x = random.uniform(x0 + 1.0, x1 - 2.0);
    const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
    const auto on_roof = [&](double px, double t) {
      return at(px, side * half * (1.0 - t), rise * t + thick + 0.08);
    };
    const double t0 = random.uniform(0.25, 0.5);
    const double t1 = t0 + 1.1 / half;
    const double w = side < 0 ? 0.9 : -0.9;
    const double start = side < 0 ? x : x + 0.9;
    builder.quad(on_roof(start, t0),
                 on_roof(start + w, t0),
                 on_roof(start + w, t1),
                 on_roof(start, t1),
                 surfaces.panes.front());
  }
}

void build_tower_roof(const BuildingStyle& style,
                      const BuildingSurfaces& surfaces,
                      const GroundFrame& frame,
                      const std::vector<WallPiece>& walls,
                      MeshBuilder& builder) {
  build_flat_roof(style, surfaces, frame, {}, walls, builder);
  const double roof = style.floors * style.floor_height_m;
  const Eigen::Vector3d center = frame * Eigen::Vector3d(0, 0, roof);
  for (const WallPiece& wall : walls) {
    builder.triangle(center,
                     frame * Eigen::Vector3d(wall.left.x(), wall.left.y(), roof),
                     frame * Eigen::Vector3d(wall.right.x(), wall.right.y(), roof),
                     surfaces.roof);
  }
  const double drum = 0.22 * style.width_m;
  const Eigen::Vector3d top = center + Eigen::Vector3d(0, 0, 2.4);
  builder.tube(center, top, drum, drum, 14, surfaces.base);
  builder.tube(top, top + Eigen::Vector3d(0, 0, 0.9), drum + 0.25, 0.65 * drum, 14, surfaces.roof);
  builder.tube(top + Eigen::Vector3d(0, 0, 0.9),
               top + Eigen::Vector3d(0, 0, 1.5),
               0.65 * drum,
               0.05,
               14,
               surfaces.roof);
}

}  // namespace

void build_roof(const BuildingStyle& style,
                const BuildingSurfaces& surfaces,
                const GroundFrame& frame,
                const std::vector<PlanRectangle>& rectangles,
                const std::vector<WallPiece>& walls,
                MeshBuilder& builder) {
  if (style.plan == FloorPlan::kTower) {
    build_tower_roof(style, surfaces, frame, walls, builder);
  } else if (style.roof == RoofShape::kFlat) {
    build_flat_roof(style, surfaces, frame, rectangles, walls, builder);
  } else {
    build_gable_roof(style, surfaces, frame, rectangles.front(), builder);
  }
}

}  // namespace hybridfusion
