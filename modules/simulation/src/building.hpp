#pragma once

#include "mesh_builder.hpp"

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

enum class RoofShape : std::uint8_t { kFlat, kGable, kHip };
enum class FloorPlan : std::uint8_t { kBox, kL, kU, kTower };

/// Everything that distinguishes one building from another.
struct BuildingStyle {
  FloorPlan plan = FloorPlan::kBox;
  RoofShape roof = RoofShape::kFlat;
  double width_m = 12.0;  ///< Along local x.
  double depth_m = 10.0;  ///< Along local y.
  int floors = 4;
  double floor_height_m = 3.0;
  double parapet_m = 0.8;
  double roof_pitch = 0.75;  ///< Rise over run.
  double eaves_m = 0.45;
  double window_width_m = 1.3;
  double window_height_m = 1.5;
  double window_spacing_m = 3.0;
  double balcony_share = 0.2;
  bool string_courses = true;
  Material wall = Material::kPlaster;
  Eigen::Vector3f wall_color = {0.5F, 0.45F, 0.38F};
  Eigen::Vector2f wall_cell_m = {0.5F, 0.25F};
  Eigen::Vector3f roof_color = {0.3F, 0.3F, 0.3F};
  Eigen::Vector3f balcony_color = {0.5F, 0.5F, 0.5F};
  float contrast = 1.0F;
  std::uint64_t seed = 0;  ///< Of its details and textures.
};

/// Surfaces of one building, all in its frame.
struct BuildingSurfaces {
  std::uint32_t wall = 0, base = 0, roof = 0, trim = 0, frame = 0, balcony = 0, metal = 0;
  std::vector<std::uint32_t> panes = {};  ///< Window panes, drawn at random.
};

/// One straight piece of outer wall, seen from outside from left to right.
struct WallPiece {
  Eigen::Vector2d left = Eigen::Vector2d::Zero();  ///< In the building's frame [m].
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  bool narrow = false;  ///< A facet of a round wall: one slit window a floor, no balconies.
  std::uint32_t index = 0;
};

/// Wall with recessed windows, sills, frames, balconies and string courses.
void build_facade(const BuildingStyle& style,
                  const BuildingSurfaces& surfaces,
                  const GroundFrame& frame,
                  const WallPiece& wall,
                  MeshBuilder& builder);

/// Rectangles [low, high] whose union is the floor plan.
struct PlanRectangle {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
};

void build_roof(const BuildingStyle& style,
                const BuildingSurfaces& surfaces,
                const GroundFrame& frame,
                const std::vector<PlanRectangle>& rectangles,
                const std::vector<WallPiece>& walls,
                MeshBuilder& builder);

/// `frame` stands in the middle of the floor plan on the highest ground along its walls.
void build_building(const BuildingStyle& style, const GroundFrame& frame, MeshBuilder& builder);

}  // namespace hybridfusion
