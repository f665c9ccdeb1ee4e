#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion {

enum class Material : std::uint8_t {
  kAsphalt,
  kPavers,
  kCobble,
  kGrass,
  kConcrete,
  kRoadPaint,
  kPlaster,
  kBrick,
  kPanels,
  kRoofTiles,
  kMembrane,
  kMetal,
  kFrame,
  kGlass,
  kCarPaint,
  kRubber,
  kBark,
  kLeaf,
  kPlain,
};

/// Face labels of truth/mesh.ply.
enum class FaceLabel : std::uint8_t { kGround = 0, kBuilding = 1, kVegetation = 2, kOther = 3 };

/// How a set of faces looks. Texture coordinates are metres in the surface's own frame, taken from
/// the two axes across the face's dominant normal axis, or unrolled around local z for a cylinder.
struct Surface {
  Material material = Material::kPlain;
  FaceLabel label = FaceLabel::kOther;
  Eigen::Matrix3f local_from_world = Eigen::Matrix3f::Identity();
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< Of the local frame, in the world [m].
  float cylinder_radius_m = 0.0F;                    ///< 0: planar.
  Eigen::Vector3f color = Eigen::Vector3f::Constant(0.5F);  ///< Linear albedo 0..1.
  Eigen::Vector2f cell_m = {0.5F, 0.25F};                   ///< Brick, tile or panel size.
  float contrast = 1.0F;
  std::uint32_t seed = 0;
  float lidar_reflectivity = 0.3F;
};

/// All triangles of the world in ENU [m], vertices not shared between patches.
struct Scene {
  std::vector<Eigen::Vector3f> vertices = {};
  std::vector<float> ambient = {};  ///< Share of the sky each vertex sees, 0..1.
  /// Factor on the linear colour of the surface, per vertex; empty: 1 everywhere.
  std::vector<Eigen::Vector3f> tint = {};
  std::vector<std::array<std::uint32_t, 3>> faces = {};
  std::vector<std::uint32_t> face_surface = {};
  std::vector<Surface> surfaces = {};
  Eigen::Vector3f sun_direction = Eigen::Vector3f::UnitZ();  ///< Towards the sun.
  double core_radius_m = 0.0;  ///< Truth samples are taken within this square half-size.
};

}  // namespace hybridfusion
