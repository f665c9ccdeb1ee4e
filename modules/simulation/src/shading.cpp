#include "shading.hpp"

#include "noise.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

/// Texture coordinates [m] of a point.
struct TexturePoint {
  float u = 0.0F;
  float v = 0.0F;
  float height = 0.0F;  ///< Over the surface's origin [m].
  bool upright = false;
};

TexturePoint texture_point(const Surface& surface,
                           const Eigen::Vector3f& point,
                           const Eigen::Vector3f& normal) {
  const Eigen::Vector3f p = surface.local_from_world * (point - surface.origin);
  const Eigen::Vector3f n = (surface.local_from_world * normal).cwiseAbs();
  if (surface.cylinder_radius_m > 0.0F && n.z() < 0.7F) {
    return {std::atan2(p.y(), p.x()) * surface.cylinder_radius_m, p.z(), p.z(), true};
  }
  if (n.z() >= n.x() && n.z() >= n.y()) {
    // On a slope v runs down the roof, not over its ground plan.
    return {p.x() / std::max(0.3F, std::sqrt(1.0F - n.x() * n.x())),
            p.y() / std::max(0.3F, std::sqrt(1.0F - n.y() * n.y())),
            p.z(),
            false};
  }
  if (n.x() > n.y()) return {p.y() + 57.0F * (p.x() > 0.0F ? 1.0F : 2.0F), p.z(), p.z(), true};
  return {p.x() + 131.0F * (p.y() > 0.0F ? 1.0F : 2.0F), p.z(), p.z(), true};
}

/// Darker and lighter clouds and a few dark blots, as weather leaves them. About 1 +- 0.15.
float weathering(const TexturePoint& t, std::uint32_t seed, float footprint) {
  const float clouds = fractal_noise(t.u, t.v, 4.0F, 7, 0.66F, seed + 101, footprint);
  const float blots = fractal_noise(t.u, t.v, 1.7F, 4, 0.5F, seed + 211, footprint);
  const float blot = std::clamp((blots - 0.62F) * 4.0F, 0.0F, 1.0F);
  return 1.0F + 0.14F * clouds - 0.22F * blot;
}

/// Rain streaks below sills and dirt near the ground.
float wall_dirt(const TexturePoint& t, std::uint32_t seed, float footprint) {
  const float streaks =
      fractal_noise(t.u * 3.0F, t.v * 0.25F, 1.0F, 3, 0.6F, seed + 307, 3.0F * footprint);
  const float foot = std::clamp(1.0F - t.height / 1.2F, 0.0F, 1.0F);
  return 1.0F - 0.10F * std::max(0.0F, streaks) - 0.18F * foot;
}

struct Masonry {
  float joint = 0.0F;  ///< Share of the pixel on mortar.
  float cell = 0.0F;   ///< Random value of the stone, -1..1, faded with the footprint.
};

/// Stones in rows; `shift` moves every other row by that share of a stone.
Masonry masonry(
    const Surface& surface, const TexturePoint& t, float shift, float joint_m, float footprint) {
  const float w = surface.cell_m.x();
  const float h = surface.cell_m.y();
  const float row = std::floor(t.v / h);
  const float odd = row - 2.0F * std::floor(row * 0.5F);
  const float u = t.u / w + shift * odd;
  const float across = filtered_pulse(t.v / h, joint_m / h, footprint / h);
  const float along = filtered_pulse(u, joint_m / w, footprint / w);
  const auto cell_x = static_cast<std::int32_t>(std::floor(u));
  const auto cell_y = static_cast<std::int32_t>(row);
  const float value = 2.0F * cell_value(cell_x, cell_y, surface.seed) - 1.0F;
  return {.joint = std::max(across, along),
          .cell = value * surviving(std::min(w, 2.0F * h), 0.8F * footprint)};
}

Eigen::Vector3f scaled(const Surface& surface, float factor) {
  return surface.color * std::max(0.05F, 1.0F + surface.contrast * (factor - 1.0F));
}

Eigen::Vector3f masonry_color(const Surface& surface,
                              const TexturePoint& t,
                              float shift,
                              float joint_m,
                              float variation,
                              float footprint) {
  const Masonry m = masonry(surface, t, shift, joint_m, footprint);
  const float grain = fractal_noise(t.u, t.v, 0.3F, 4, 0.7F, surface.seed + 5, footprint);
  float factor =
      (1.0F + variation * m.cell + 0.10F * grain) * weathering(t, surface.seed, footprint);
  if (t.upright) factor *= wall_dirt(t, surface.seed, footprint);
  factor *= 1.0F - 0.38F * m.joint;
  return scaled(surface, factor);
}

Eigen::Vector3f asphalt_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const float speckle = fractal_noise(t.u, t.v, 0.4F, 5, 0.8F, surface.seed + 3, footprint);
  const float crack_field = fractal_noise(t.u, t.v, 3.2F, 4, 0.55F, surface.seed + 17, footprint);
  const float width = std::max(0.012F, 0.5F * footprint);
  const float where = fractal_noise(t.u, t.v, 9.0F, 2, 0.5F, surface.seed + 29, footprint);
  const float crack = where > 0.05F
                          ? std::max(0.0F, 1.0F - std::abs(crack_field) / (0.9F * width)) *
                                std::min(1.0F, 0.012F / width + 0.3F)
                          : 0.0F;
  // Repaired patches: cells of a coarse grid, a few of them of another age.
  const auto px = static_cast<std::int32_t>(std::floor(t.u / 7.3F));
  const auto py = static_cast<std::int32_t>(std::floor(t.v / 5.1F));
  const float patch = cell_value(px, py, surface.seed + 41) < 0.16F ? -0.14F : 0.0F;
  const float weather = 1.0F + 1.5F * (weathering(t, surface.seed, footprint) - 1.0F);
  const float factor = (1.0F + patch + 0.15F * speckle) * weather * (1.0F - 0.45F * crack);
  return scaled(surface, factor);
}

Eigen::Vector3f grass_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const float wide = fractal_noise(t.u, t.v, 24.0F, 5, 0.62F, surface.seed, footprint);
  const float fine = fractal_noise(t.u, t.v, 0.9F, 5, 0.8F, surface.seed + 77, footprint);
  const float dry = std::clamp(0.5F + 0.55F * wide + 0.15F * fine, 0.0F, 1.0F) * surface.contrast;
  const Eigen::Vector3f straw(0.30F, 0.27F, 0.15F);
  const Eigen::Vector3f mixed = surface.color + std::min(1.0F, dry) * (straw - surface.color);
  return mixed * std::max(0.1F, 1.0F + surface.contrast * (0.24F * fine + 0.12F * wide));
}

Eigen::Vector3f paint_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const float wear = fractal_noise(t.u, t.v, 0.6F, 5, 0.75F, surface.seed, footprint);
  const float worn = std::clamp((wear - 0.25F) * 2.5F, 0.0F, 1.0F);
  const Eigen::Vector3f road = Eigen::Vector3f::Constant(0.14F);
  return (surface.color + (0.75F * worn) * (road - surface.color)) *
         (1.0F + 0.08F * surface.contrast * wear);
}

Eigen::Vector3f membrane_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const float seam = filtered_pulse(
      t.v / surface.cell_m.y(), 0.03F / surface.cell_m.y(), footprint / surface.cell_m.y());
  const float grain = fractal_noise(t.u, t.v, 0.5F, 5, 0.75F, surface.seed + 9, footprint);
  const float puddles = fractal_noise(t.u, t.v, 5.0F, 4, 0.5F, surface.seed + 19, footprint);
  const float puddle = std::clamp((puddles - 0.35F) * 3.0F, 0.0F, 1.0F);
  return scaled(surface,
                (1.0F - 0.25F * seam) * (1.0F + 0.09F * grain - 0.18F * puddle) *
                    weathering(t, surface.seed, footprint));
}

Eigen::Vector3f roof_tile_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const Masonry m = masonry(surface, t, 0.5F, 0.03F, footprint);
  const float row = t.v / surface.cell_m.y();
  const float shade = (row - std::floor(row) - 0.5F) * surviving(surface.cell_m.y(), footprint);
  const float factor = (1.0F + 0.22F * m.cell + 0.16F * shade) * (1.0F - 0.3F * m.joint) *
                       weathering(t, surface.seed, footprint);
  return scaled(surface, factor);
}

Eigen::Vector3f metal_color(const Surface& surface, const TexturePoint& t, float footprint) {
  const float wave =
      filtered_pulse(t.u / surface.cell_m.x(), 0.35F, footprint / surface.cell_m.x());
  const float stain = fractal_noise(t.u, t.v, 0.7F, 4, 0.6F, surface.seed, footprint);
  return scaled(surface, 1.0F + 0.12F * (0.35F - wave) + 0.10F * stain);
}

Eigen::Vector3f glass_color(const Surface& surface,
                            const Eigen::Vector3f& normal,
                            const Eigen::Vector3f& view,
                            const TexturePoint& t,
                            float footprint) {
  const float cosine = std::abs(normal.dot(view));
  const float mirror = 0.05F + 0.7F * std::pow(1.0F - cosine, 4.0F);
  const float folds =
      value_noise(9.0F * t.u, 0.3F * t.v, surface.seed) * surviving(0.11F, footprint);
  const Eigen::Vector3f behind = surface.color * (0.55F + 0.12F * folds);
  const Eigen::Vector3f out = 2.0F * normal.dot(view) * normal - view;
  return behind * (1.0F - mirror) + mirror * 0.45F * sky_color(out);
}

}  // namespace

Eigen::Vector3f sky_color(const Eigen::Vector3f& direction) {
  const float up = std::clamp(direction.z(), 0.0F, 1.0F);
  const Eigen::Vector3f horizon(0.75F, 0.80F, 0.86F);
  const Eigen::Vector3f zenith(0.35F, 0.50F, 0.80F);
  return horizon + up * (zenith - horizon);
}

Eigen::Vector3f face_normal(const Scene& scene, std::uint32_t face) {
  const auto& f = scene.faces[face];
  const Eigen::Vector3f& a = scene.vertices[f[0]];
  return (scene.vertices[f[1]] - a).cross(scene.vertices[f[2]] - a).normalized();
}

float ambient_at(const Scene& scene, const RayHit& hit) {
  const auto& f = scene.faces[hit.face];
  return (1.0F - hit.u - hit.v) * scene.ambient[f[0]] + hit.u * scene.ambient[f[1]] +
         hit.v * scene.ambient[f[2]];
}

Eigen::Vector3f tint_at(const Scene& scene, const RayHit& hit) {
  if (scene.tint.empty()) return Eigen::Vector3f::Ones();
  const auto& f = scene.faces[hit.face];
  return (1.0F - hit.u - hit.v) * scene.tint[f[0]] + hit.u * scene.tint[f[1]] +
         hit.v * scene.tint[f[2]];
}

Eigen::Vector3f surface_color(const Surface& surface,
                              const Eigen::Vector3f& point,
                              const Eigen::Vector3f& normal,
                              const Eigen::Vector3f& view,
                              float footprint) {
  const TexturePoint t = texture_point(surface, point, normal);
  switch (surface.material) {
    case Material::kAsphalt:
      return asphalt_color(surface, t, footprint);
    case Material::kPavers:
      return masonry_color(surface, t, 0.0F, 0.022F, 0.13F, footprint);
    case Material::kCobble:
      return masonry_color(surface, t, 0.5F, 0.025F, 0.20F, footprint);
    case Material::kGrass:
      return grass_color(surface, t, footprint);
    case Material::kRoadPaint:
      return paint_color(surface, t, footprint);
    case Material::kBrick:
      return masonry_color(surface, t, 0.5F, 0.024F, 0.19F, footprint);
    case Material::kPanels:
      return masonry_color(surface, t, 0.0F, 0.025F, 0.13F, footprint);
    case Material::kRoofTiles:
      return roof_tile_color(surface, t, footprint);
    case Material::kMembrane:
      return membrane_color(surface, t, footprint);
    case Material::kMetal:
      return metal_color(surface, t, footprint);
    case Material::kGlass:
      return glass_color(surface, normal, view, t, footprint);
    case Material::kPlaster:
    case Material::kConcrete:
    case Material::kBark:
    case Material::kCarPaint: {
      const float grain = fractal_noise(t.u, t.v, 0.5F, 5, 0.7F, surface.seed + 7, footprint);
      float factor = (1.0F + 0.10F * grain) * weathering(t, surface.seed, footprint);
      if (t.upright && surface.material == Material::kPlaster) {
        factor *= wall_dirt(t, surface.seed, footprint);
      }
      return scaled(surface, factor);
    }
    case Material::kLeaf: {
      // A hash of the place gives each leaf its own green.
      const auto cell = [](float x) { return static_cast<std::int32_t>(std::floor(x / 0.45F)); };
      const float leaf =
          cell_value(cell(point.x()), cell(point.y()) + 7919 * cell(point.z()), surface.seed);
      return surface.color * (0.65F + 0.7F * leaf);
    }
    case Material::kFrame:
    case Material::kRubber:
    case Material::kPlain:
      return surface.color;
  }
  return surface.color;
}

}  // namespace hybridfusion
