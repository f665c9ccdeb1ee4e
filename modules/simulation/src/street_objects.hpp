#pragma once

#include "mesh_builder.hpp"

#include <cstdint>

namespace hybridfusion {

/// Frames stand on the ground; x is along the street.
void build_car(const GroundFrame& frame, std::uint64_t seed, float contrast, MeshBuilder& builder);
void build_tree(const GroundFrame& frame,
                double height_m,
                std::uint64_t seed,
                MeshBuilder& builder);
/// The arm points along +y.
void build_lamp_post(const GroundFrame& frame, std::uint64_t seed, MeshBuilder& builder);
/// A traffic sign, bin, distribution box or bench.
void build_street_furniture(const GroundFrame& frame,
                            std::uint64_t seed,
                            float contrast,
                            MeshBuilder& builder);

}  // namespace hybridfusion
