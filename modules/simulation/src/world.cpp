#include "world.hpp"

#include <hybridfusion/core/random.hpp>

#include <cmath>
#include <numbers>

namespace hybridfusion {

Expected<World> build_world(const WorldOptions& options,
                            std::uint64_t seed,
                            const RunContext& ctx) {
  ctx.report({.stage = "simulate/world", .done = 0, .total = 1});
  Expected<World> loaded = options.mesh.empty() ? Expected<World>(generate_town(options, seed))
                                                : load_world(options, seed);
  if (!loaded) return loaded;
  World world = *std::move(loaded);
  Random random(seed, "world/sun");
  const double elevation = random.uniform(0.65, 1.0);
  // Somewhere in the southern half of the sky.
  const double azimuth = random.uniform(-0.9, -0.1) * std::numbers::pi;
  world.scene.sun_direction = Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                              std::cos(elevation) * std::sin(azimuth),
                                              std::sin(elevation))
                                  .cast<float>();
  world.scene.core_radius_m = world.terrain.plan().core_half_m.maxCoeff() + 2.0;
  if (Expected<void> baked = bake_ambient_light(world.scene, options.ambient_rays, seed, ctx);
      !baked) {
    return std::unexpected(std::move(baked).error());
  }
  ctx.report({.stage = "simulate/world", .done = 1, .total = 1});
  return world;
}

}  // namespace hybridfusion
