#include "building.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr double kParapetThickness_m = 0.28;

/// Boxes and pipes that stand on flat roofs.
void build_roof_clutter(const BuildingSurfaces& surfaces,
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
    build_roof_clutter(surfaces, frame, r, roof, random, builder);
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

constexpr double kRoofThickness_m = 0.22;

/// Two slopes over a box, ridge along local x; eaves stand out over the walls.
struct PitchedRoof {
  GroundFrame frame;
  double wall_top = 0.0;
  double x0 = 0.0;  ///< Gable walls.
  double x1 = 0.0;
  double e0 = 0.0;  ///< Ends of the eaves.
  double e1 = 0.0;
  double ridge0 = 0.0;  ///< Ends of the ridge.
  double ridge1 = 0.0;
  double half = 0.0;  ///< Half the width of the box.
  double eave = 0.0;  ///< Half the width over the eaves.
  double drop = 0.0;  ///< Of the eaves below the top of the wall.
  double rise = 0.0;  ///< Of the ridge over it.

  /// World point; z counts from the top of the wall.
  [[nodiscard]] Eigen::Vector3d at(double x, double y, double z) const {
    return frame * Eigen::Vector3d(x, y, wall_top + z);
  }
};

PitchedRoof pitched_roof(const BuildingStyle& style,
                         const GroundFrame& frame,
                         const PlanRectangle& r) {
  PitchedRoof roof{.frame = frame, .wall_top = style.floors * style.floor_height_m};
  roof.half = 0.5 * (r.high.y() - r.low.y());
  roof.eave = roof.half + style.eaves_m;
  roof.drop = style.eaves_m * style.roof_pitch;
  roof.rise = roof.half * style.roof_pitch;
  roof.x0 = r.low.x();
  roof.x1 = r.high.x();
  roof.e0 = roof.x0 - style.eaves_m;
  roof.e1 = roof.x1 + style.eaves_m;
  const bool hip = style.roof == RoofShape::kHip;
  const double inset = std::min(roof.half, 0.45 * (roof.x1 - roof.x0));
  roof.ridge0 = hip ? roof.x0 + inset : roof.e0;
  roof.ridge1 = hip ? roof.x1 - inset : roof.e1;
  return roof;
}

/// Tiles, edge board and underside of the slope on one side of the ridge (-1 or 1).
void build_slope(const PitchedRoof& roof,
                 double side,
                 const BuildingSurfaces& surfaces,
                 MeshBuilder& builder) {
  const double y = side * roof.eave;
  const double a = side < 0 ? roof.e0 : roof.e1;
  const double b = side < 0 ? roof.e1 : roof.e0;
  const double ra = side < 0 ? roof.ridge0 : roof.ridge1;
  const double rb = side < 0 ? roof.ridge1 : roof.ridge0;
  const double top = kRoofThickness_m - roof.drop;
  builder.quad(roof.at(a, y, top),
               roof.at(b, y, top),
               roof.at(rb, 0, roof.rise + kRoofThickness_m),
               roof.at(ra, 0, roof.rise + kRoofThickness_m),
               surfaces.roof);
  builder.quad(roof.at(a, y, -roof.drop),
               roof.at(b, y, -roof.drop),
               roof.at(b, y, top),
               roof.at(a, y, top),
               surfaces.trim);
  builder.quad(roof.at(b, y, -roof.drop),
               roof.at(a, y, -roof.drop),
               roof.at(a, side * roof.half, 0),
               roof.at(b, side * roof.half, 0),
               surfaces.trim);
}

/// The sloping end of a hip roof.
void build_hip_end(const PitchedRoof& roof,
                   double side,
                   const BuildingSurfaces& surfaces,
                   MeshBuilder& builder) {
  const double x = side < 0 ? roof.x0 : roof.x1;
  const double e = side < 0 ? roof.e0 : roof.e1;
  const double y = side * roof.eave;
  const double top = kRoofThickness_m - roof.drop;
  const Eigen::Vector3d apex =
      roof.at(side < 0 ? roof.ridge0 : roof.ridge1, 0, roof.rise + kRoofThickness_m);
  builder.quad(roof.at(e, -y, top), roof.at(e, y, top), apex, apex, surfaces.roof);
  builder.quad(roof.at(e, -y, -roof.drop),
               roof.at(e, y, -roof.drop),
               roof.at(e, y, top),
               roof.at(e, -y, top),
               surfaces.trim);
  builder.quad(roof.at(e, y, -roof.drop),
               roof.at(e, -y, -roof.drop),
               roof.at(x, -side * roof.half, 0),
               roof.at(x, side * roof.half, 0),
               surfaces.trim);
}

/// The gable wall and the boards of the roof that stands out over it.
void build_gable_end(const PitchedRoof& roof,
                     double side,
                     const BuildingSurfaces& surfaces,
                     MeshBuilder& builder) {
  const double x = side < 0 ? roof.x0 : roof.x1;
  const double e = side < 0 ? roof.e0 : roof.e1;
  builder.quad(roof.at(x, -side * roof.half, 0),
               roof.at(x, side * roof.half, 0),
               roof.at(x, 0, roof.rise),
               roof.at(x, 0, roof.rise),
               surfaces.wall);
  const Eigen::Vector3d lift(0, 0, kRoofThickness_m);
  for (const double wing : {-1.0, 1.0}) {
    const Eigen::Vector3d low = roof.at(e, wing * roof.eave, -roof.drop);
    const Eigen::Vector3d high = roof.at(e, 0, roof.rise);
    if (wing * side > 0) {
      builder.quad(low, low + lift, high + lift, high, surfaces.trim);
    } else {
      builder.quad(high, high + lift, low + lift, low, surfaces.trim);
    }
    const Eigen::Vector3d wall_low = roof.at(x, wing * roof.eave, -roof.drop);
    const Eigen::Vector3d wall_high = roof.at(x, 0, roof.rise);
    builder.quad(low, wall_low, wall_high, high, surfaces.trim);
  }
}

void build_chimney(const PitchedRoof& roof,
                   const BuildingSurfaces& surfaces,
                   Random& random,
                   MeshBuilder& builder) {
  const double x = random.uniform(roof.x0 + 1.0, roof.x1 - 1.0);
  const double y = random.uniform(-0.5, 0.5) * roof.half;
  builder.box(roof.frame,
              {x - 0.4, y - 0.35, roof.wall_top},
              {x + 0.4, y + 0.35, roof.wall_top + roof.rise + 1.1},
              surfaces.trim,
              16);
}

/// Windows a hand above the tiles.
void build_roof_lights(const PitchedRoof& roof,
                       const BuildingSurfaces& surfaces,
                       Random& random,
                       MeshBuilder& builder) {
  const int lights = static_cast<int>(random.uniform(1.0, 4.0));
  for (int i = 0; i < lights; ++i) {
    const double x = random.uniform(roof.x0 + 1.0, roof.x1 - 2.0);
    const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
    const auto on_roof = [&](double px, double t) {
      return roof.at(px, side * roof.half * (1.0 - t), roof.rise * t + kRoofThickness_m + 0.08);
    };
    const double t0 = random.uniform(0.25, 0.5);
    const double t1 = t0 + 1.1 / roof.half;
    const double w = side < 0 ? 0.9 : -0.9;
    const double start = side < 0 ? x : x + 0.9;
    builder.quad(on_roof(start, t0),
                 on_roof(start + w, t0),
                 on_roof(start + w, t1),
                 on_roof(start, t1),
                 surfaces.panes.front());
  }
}

void build_pitched_roof(const BuildingStyle& style,
                        const BuildingSurfaces& surfaces,
                        const GroundFrame& frame,
                        const PlanRectangle& r,
                        MeshBuilder& builder) {
  Random random(style.seed, "world/roof");
  const PitchedRoof roof = pitched_roof(style, frame, r);
  const bool hip = style.roof == RoofShape::kHip;
  for (const double side : {-1.0, 1.0}) build_slope(roof, side, surfaces, builder);
  for (const double side : {-1.0, 1.0}) {
    (hip ? build_hip_end : build_gable_end)(roof, side, surfaces, builder);
  }
  build_chimney(roof, surfaces, random, builder);
  if (!hip) build_roof_lights(roof, surfaces, random, builder);
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
    build_pitched_roof(style, surfaces, frame, rectangles.front(), builder);
  }
}

}  // namespace hybridfusion
