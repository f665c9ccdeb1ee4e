#include "ray_tracer.hpp"
#include "world.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr float kAmbientReach_m = 12.0F;

/// Free share of the cosine-weighted hemisphere over `point`.
float open_sky(const RayTracer& tracer,
               const Eigen::Vector3f& point,
               const Eigen::Vector3f& normal,
               int rays,
               Random& random) {
  const Eigen::Vector3f u = normal.unitOrthogonal();
  const Eigen::Vector3f v = normal.cross(u);
  const auto turn = static_cast<float>(random.uniform());
  int open = 0;
  for (int i = 0; i < rays; ++i) {
    // Golden-angle spiral: even coverage with few rays.
    const float height = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays);
    const float angle =
        2.0F * std::numbers::pi_v<float> * (0.61803399F * static_cast<float>(i) + turn);
    const float r = std::sqrt(height);
    const Eigen::Vector3f direction =
        r * std::cos(angle) * u + r * std::sin(angle) * v + std::sqrt(1.0F - height) * normal;
    if (direction.z() > -0.3F && !tracer.blocked(point, direction, 0.0F, kAmbientReach_m)) ++open;
  }
  return static_cast<float>(open) / static_cast<float>(rays);
}

}  // namespace

Expected<void> bake_ambient_light(Scene& scene,
                                  int rays,
                                  std::uint64_t seed,
                                  const RunContext& ctx) {
  const RayTracer tracer(scene);
  scene.ambient.assign(scene.vertices.size(), -1.0F);
  // Each vertex is lit from the first face that uses it.
  std::vector<std::uint32_t> owner(scene.vertices.size(), kNoFace);
  for (std::size_t face = 0; face < scene.faces.size(); ++face) {
    for (const std::uint32_t vertex : scene.faces[face]) {
      if (owner[vertex] == kNoFace) owner[vertex] = static_cast<std::uint32_t>(face);
    }
  }
  const auto light_vertex = [&](std::size_t i, Random& random) {
    const auto& face = scene.faces[owner[i]];
    const Eigen::Vector3f& a = scene.vertices[face[0]];
    const Eigen::Vector3f& b = scene.vertices[face[1]];
    const Eigen::Vector3f& c = scene.vertices[face[2]];
    const bool leaf = scene.surfaces[scene.face_surface[owner[i]]].material == Material::kLeaf;
    if (leaf && i % 4 != 0) return;  // Its neighbours take the value over.
    Eigen::Vector3f normal = (b - a).cross(c - a).normalized();
    if (!normal.allFinite()) normal = Eigen::Vector3f::UnitZ();
    if (leaf && normal.z() < 0.0F) normal = -normal;
    const Eigen::Vector3f center = (a + b + c) / 3.0F;
    const Eigen::Vector3f point =
        scene.vertices[i] + 0.06F * (center - scene.vertices[i]) + 0.01F * normal;
    const bool far = point.head<2>().cwiseAbs().maxCoeff() > scene.core_radius_m + 15.0;
    scene.ambient[i] =
        far ? 1.0F : open_sky(tracer, point, normal, leaf ? std::max(4, rays / 3) : rays, random);
  };
  constexpr std::size_t kGrain = 4096;
  constexpr std::size_t kSlab = 16 * kGrain;
  for (std::size_t slab = 0; slab < scene.vertices.size() && !ctx.stopped(); slab += kSlab) {
    const std::size_t count = std::min(kSlab, scene.vertices.size() - slab);
    parallel_for(ctx, count, kGrain, [&](std::size_t begin, std::size_t end) {
      Random random(seed, "world/ambient", slab + begin);
      for (std::size_t i = slab + begin; i < slab + end; ++i) {
        if (owner[i] != kNoFace) light_vertex(i, random);
      }
    });
    ctx.report({.stage = "simulate/light",
                .done = static_cast<std::int64_t>(slab + count),
                .total = static_cast<std::int64_t>(scene.vertices.size())});
  }
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while baking the ambient light");
  for (std::size_t i = 0; i < scene.ambient.size(); ++i) {
    if (scene.ambient[i] < 0.0F) scene.ambient[i] = i == 0 ? 1.0F : scene.ambient[i - 1];
  }
  return {};
}

}  // namespace hybridfusion
