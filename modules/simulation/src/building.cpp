#include "building.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

Surface building_surface(const BuildingStyle& style,
                         Material material,
                         Eigen::Vector3f color,
                         Eigen::Vector2f cell,
                         float reflectivity,
                         std::uint32_t salt) {
  Surface surface{.material = material, .label = FaceLabel::kBuilding, .color = color};
  surface.cell_m = cell;
  surface.contrast = style.contrast;
  surface.seed = static_cast<std::uint32_t>(style.seed) * 2654435761U + salt * 7919U;
  surface.lidar_reflectivity = reflectivity;
  return surface;
}

BuildingSurfaces add_surfaces(const BuildingStyle& style,
                              const GroundFrame& frame,
                              MeshBuilder& builder) {
  Random random(style.seed, "world/building-colors");
  const auto add = [&](Material material,
                       const Eigen::Vector3f& color,
                       Eigen::Vector2f cell,
                       float reflectivity,
                       std::uint32_t salt) {
    Surface surface = building_surface(style, material, color, cell, reflectivity, salt);
    if (style.plan == FloorPlan::kTower && material == style.wall) {
      surface.cylinder_radius_m = static_cast<float>(0.5 * style.width_m);
    }
    return builder.add_surface(surface, frame);
  };
  const auto grey = [&](double low, double high) -> Eigen::Vector3f {
    return Eigen::Vector3f::Constant(static_cast<float>(random.uniform(low, high)));
  };
  BuildingSurfaces s;
  s.wall = add(style.wall, style.wall_color, style.wall_cell_m, 0.45F, 1);
  const bool stone_base = random.uniform() < 0.6;
  s.base = stone_base ? add(Material::kPanels, grey(0.22, 0.4), {0.9F, 0.45F}, 0.4F, 2)
                      : add(style.wall, 0.8F * style.wall_color, style.wall_cell_m, 0.4F, 3);
  const bool flat = style.roof == RoofShape::kFlat;
  s.roof = add(flat ? Material::kMembrane : Material::kRoofTiles,
               style.roof_color,
               flat ? Eigen::Vector2f(4.0F, 2.6F) : Eigen::Vector2f(0.32F, 0.42F),
               0.3F,
               4);
  s.trim = add(Material::kConcrete, grey(0.26, 0.48), {1, 1}, 0.5F, 5);
  s.frame = add(Material::kFrame,
                random.uniform() < 0.7 ? grey(0.5, 0.75) : grey(0.05, 0.12),
                {1, 1},
                0.5F,
                6);
  s.balcony = add(Material::kMetal, style.balcony_color, {0.25F, 1.0F}, 0.4F, 7);
  s.metal = add(Material::kMetal, grey(0.2, 0.4), {0.12F, 1.0F}, 0.5F, 8);
  for (std::uint32_t pane = 0; pane < 7; ++pane) {
    // Dark rooms, grey blinds, and now and then a curtain with a tint.
    const double value =
        random.uniform() < 0.5 ? random.uniform(0.02, 0.08) : random.uniform(0.1, 0.4);
    const Eigen::Vector3f curtain(static_cast<float>(value * random.uniform(0.9, 1.15)),
                                  static_cast<float>(value * random.uniform(0.85, 1.05)),
                                  static_cast<float>(value * random.uniform(0.75, 1.1)));
    s.panes.push_back(add(Material::kGlass, curtain, {0.5F, 0.5F}, 0.05F, 20 + pane));
  }
  return s;
}

/// Corners of the floor plan, counter-clockwise, and the rectangles that cover it.
void floor_plan(const BuildingStyle& style,
                std::vector<Eigen::Vector2d>& corners,
                std::vector<PlanRectangle>& rectangles) {
  const double x = 0.5 * style.width_m;
  const double y = 0.5 * style.depth_m;
  switch (style.plan) {
    case FloorPlan::kBox:
      corners = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
      rectangles = {{{-x, -y}, {x, y}}};
      return;
    case FloorPlan::kL: {
      const double cx = 0.05 * x;
      const double cy = 0.0;
      corners = {{-x, -y}, {cx, -y}, {cx, cy}, {x, cy}, {x, y}, {-x, y}};
      rectangles = {{{-x, -y}, {cx, cy}}, {{-x, cy}, {x, y}}};
      return;
    }
    case FloorPlan::kU: {
      const double cx = 0.36 * x;
      const double cy = -0.05 * y;
      corners = {{-x, -y}, {x, -y}, {x, y}, {cx, y}, {cx, cy}, {-cx, cy}, {-cx, y}, {-x, y}};
      rectangles = {{{-x, -y}, {x, cy}}, {{cx, cy}, {x, y}}, {{-x, cy}, {-cx, y}}};
      return;
    }
    case FloorPlan::kTower: {
      const int sides = 2 * static_cast<int>(std::lround(std::numbers::pi * x / 0.9));
      for (int side = 0; side < sides; ++side) {
        const double angle = 2.0 * std::numbers::pi * side / sides;
        corners.emplace_back(x * std::cos(angle), x * std::sin(angle));
      }
      return;
    }
  }
}

}  // namespace

void build_building(const BuildingStyle& style, const GroundFrame& frame, MeshBuilder& builder) {
  std::vector<Eigen::Vector2d> corners;
  std::vector<PlanRectangle> rectangles;
  floor_plan(style, corners, rectangles);
  const BuildingSurfaces surfaces = add_surfaces(style, frame, builder);
  std::vector<WallPiece> walls;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    walls.push_back({.left = corners[i],
                     .right = corners[(i + 1) % corners.size()],
                     .narrow = style.plan == FloorPlan::kTower,
                     .index = static_cast<std::uint32_t>(i)});
  }
  for (const WallPiece& wall : walls) build_facade(style, surfaces, frame, wall, builder);
  build_roof(style, surfaces, frame, rectangles, walls, builder);
}

}  // namespace hybridfusion
