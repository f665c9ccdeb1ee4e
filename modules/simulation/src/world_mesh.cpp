#include "world.hpp"

#include <hybridfusion/io/ply.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Surface surface_of_label(FaceLabel label, float contrast) {
  Surface surface{.label = label};
  surface.contrast = contrast;
  surface.seed = 101U + static_cast<std::uint32_t>(label);
  switch (label) {
    case FaceLabel::kGround:
      surface.material = Material::kPavers;
      surface.color = {0.3F, 0.29F, 0.28F};
      break;
    case FaceLabel::kVegetation:
      surface.material = Material::kLeaf;
      surface.color = {0.1F, 0.17F, 0.05F};
      break;
    case FaceLabel::kBuilding:
      surface.material = Material::kBrick;
      surface.color = {0.42F, 0.33F, 0.25F};
      surface.cell_m = {0.6F, 0.28F};
      break;
    case FaceLabel::kOther:
      surface.material = Material::kConcrete;
      surface.color = {0.35F, 0.35F, 0.35F};
      break;
  }
  return surface;
}

/// The mesh's own colours take the place of its surfaces' colours; the grain of the surfaces stays.
void tint_by_colors(const TriangleMesh& mesh,
                    const std::array<std::uint32_t, 4>& surfaces,
                    Scene& scene) {
  for (const std::uint32_t id : surfaces) scene.surfaces[id].color = Eigen::Vector3f::Ones();
  scene.tint.assign(scene.vertices.size(), Eigen::Vector3f::Ones());
  constexpr float kDisplayGamma = 2.2F;
  const auto linear = [](std::uint8_t value) {
    return std::pow(static_cast<float>(value) / 255.0F, kDisplayGamma);
  };
  for (const Rgb8& color : mesh.colors) {
    scene.tint.emplace_back(linear(color[0]), linear(color[1]), linear(color[2]));
  }
}

}  // namespace

Expected<World> load_world(const WorldOptions& options, std::uint64_t seed) {
  HF_TRY(const TriangleMesh mesh, read_ply_mesh(options.mesh));
  if (mesh.triangles.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("'{}' holds no faces; world.mesh needs a surface", options.mesh));
  }
  Eigen::Vector3f low = mesh.vertices.front();
  Eigen::Vector3f high = low;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const Eigen::Vector3f size = high - low;
  constexpr float kLargest_m = 2000.0F;
  if (size.maxCoeff() > kLargest_m || size.head<2>().maxCoeff() < 1.0F) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("'{}' is {:.3g} x {:.3g} x {:.3g} m; 1 to {} m are expected (metres, z "
                            "up)",
                            options.mesh,
                            size.x(),
                            size.y(),
                            size.z(),
                            kLargest_m));
  }
  // One block whose streets run around the mesh at 7 m.
  StreetPlan plan;
  constexpr double kStreetDistance_m = 7.0;
  const Eigen::Vector2d half = 0.5 * size.head<2>().cast<double>();
  plan.street_x = {-half.x() - kStreetDistance_m, half.x() + kStreetDistance_m};
  plan.street_y = {-half.y() - kStreetDistance_m, half.y() + kStreetDistance_m};
  plan.core_half_m = half + Eigen::Vector2d::Constant(kStreetDistance_m + plan.street_width_m);
  World world{.scene = {}, .terrain = Terrain(plan, 0.0, seed)};
  MeshBuilder builder(world.scene, 1.1);
  build_ground(world.terrain, static_cast<float>(options.texture_contrast), seed, builder);
  std::array<std::uint32_t, 4> surfaces{};
  for (std::size_t label = 0; label < surfaces.size(); ++label) {
    surfaces[label] =
        builder.add_surface(surface_of_label(static_cast<FaceLabel>(label),
                                             static_cast<float>(options.texture_contrast)),
                            {});
  }
  const Eigen::Vector3f shift(-0.5F * (low.x() + high.x()), -0.5F * (low.y() + high.y()), -low.z());
  const auto first = static_cast<std::uint32_t>(world.scene.vertices.size());
  if (!mesh.colors.empty()) tint_by_colors(mesh, surfaces, world.scene);
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    world.scene.vertices.push_back(vertex + shift);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    world.scene.faces.push_back({first + t[0], first + t[1], first + t[2]});
    const std::size_t label = mesh.labels.empty() ? 1 : std::min<std::size_t>(3, mesh.labels[i]);
    world.scene.face_surface.push_back(surfaces[label]);
  }
  return world;
}

}  // namespace hybridfusion
