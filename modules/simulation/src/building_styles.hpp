#pragma once

#include "building.hpp"

#include <cstdint>

namespace hybridfusion {

/// Draws wall material, colours, roof, windows and floors for a lot of the given size. The shape is
/// `plan`; small lots get a box.
[[nodiscard]] BuildingStyle random_building_style(
    FloorPlan plan, double width_m, double depth_m, float contrast, std::uint64_t seed);

}  // namespace hybridfusion
