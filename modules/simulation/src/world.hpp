#pragma once

#include "scene.hpp"
#include "terrain.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

namespace hybridfusion {

struct World {
  Scene scene = {};
  Terrain terrain;
};

/// Generates the block(s), or loads `options.mesh` onto empty ground, and bakes the ambient light.
/// Every part has its own random stream derived from `seed`.
[[nodiscard]] Expected<World> build_world(const WorldOptions& options,
                                          std::uint64_t seed,
                                          const RunContext& ctx);

/// Ground, streets, houses and street objects of a town, or a bare field (variant "flat"); without
/// light.
[[nodiscard]] World generate_town(const WorldOptions& options, std::uint64_t seed);

/// Puts the mesh of `options.mesh` on flat ground: moved so that the middle of its bounds is the
/// origin and its lowest point lies on the ground; brick walls, or materials by its face labels.
/// Without light (see bake_ambient_light). @returns kInsufficient without faces or for a size that
/// cannot be metres; what reading the file returns.
[[nodiscard]] Expected<World> load_world(const WorldOptions& options, std::uint64_t seed);

/// Fills `scene.ambient`: the share of the cosine-weighted sky over each vertex that is free of
/// geometry within 12 m. Vertices of one leaf share one value.
[[nodiscard]] Expected<void> bake_ambient_light(Scene& scene,
                                                int rays,
                                                std::uint64_t seed,
                                                const RunContext& ctx);

}  // namespace hybridfusion
