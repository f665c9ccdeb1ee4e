#pragma once

#include "mesh_builder.hpp"
#include "terrain.hpp"

#include <hybridfusion/simulation/simulation_options.hpp>

#include <cstdint>

namespace hybridfusion {

/// Trees, lamp posts, furniture and parked cars along every street; cars stand in the painted bays
/// on the +x and +y sides.
void line_streets(const WorldOptions& options,
                  const Terrain& terrain,
                  float contrast,
                  std::uint64_t seed,
                  MeshBuilder& builder);

}  // namespace hybridfusion
