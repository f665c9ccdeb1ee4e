#include "building_styles.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <array>

namespace hybridfusion {
namespace {

Eigen::Vector3f jittered(const std::array<float, 3>& color, Random& random) {
  const auto value = static_cast<float>(random.uniform(0.85, 1.15));
  Eigen::Vector3f out;
  for (int i = 0; i < 3; ++i) {
    out[i] =
        color[static_cast<std::size_t>(i)] * value * static_cast<float>(random.uniform(0.93, 1.07));
  }
  return out.cwiseMin(0.85F);
}

void choose_walls(BuildingStyle& style, Random& random) {
  static constexpr std::array<std::array<float, 3>, 7> kPlasters = {{{0.52F, 0.45F, 0.30F},
                                                                     {0.55F, 0.52F, 0.46F},
                                                                     {0.44F, 0.30F, 0.24F},
                                                                     {0.33F, 0.38F, 0.43F},
                                                                     {0.47F, 0.47F, 0.36F},
                                                                     {0.34F, 0.27F, 0.22F},
                                                                     {0.50F, 0.36F, 0.34F}}};
  static constexpr std::array<std::array<float, 3>, 5> kBricks = {{{0.40F, 0.16F, 0.10F},
                                                                   {0.48F, 0.33F, 0.20F},
                                                                   {0.34F, 0.22F, 0.19F},
                                                                   {0.50F, 0.44F, 0.33F},
                                                                   {0.26F, 0.26F, 0.27F}}};
  const double kind = random.uniform();
  if (kind < 0.35) {
    style.wall = Material::kPlaster;
    style.wall_color = jittered(kPlasters[random.index(kPlasters.size())], random);
  } else if (kind < 0.75) {
    style.wall = Material::kBrick;
    style.wall_color = jittered(kBricks[random.index(kBricks.size())], random);
    const auto size = static_cast<float>(random.uniform(0.35, 0.75));
    style.wall_cell_m = {size, 0.45F * size};
  } else {
    style.wall = Material::kPanels;
    style.wall_color = jittered(kPlasters[random.index(kPlasters.size())], random);
    style.wall_cell_m = {static_cast<float>(random.uniform(0.7, 1.6)),
                         static_cast<float>(random.uniform(0.6, 1.1))};
  }
}

void choose_roof(BuildingStyle& style, Random& random) {
  static constexpr std::array<std::array<float, 3>, 4> kMembranes = {
      {{0.29F, 0.29F, 0.30F}, {0.21F, 0.29F, 0.23F}, {0.34F, 0.31F, 0.27F}, {0.23F, 0.23F, 0.26F}}};
  static constexpr std::array<std::array<float, 3>, 3> kTiles = {
      {{0.40F, 0.16F, 0.09F}, {0.24F, 0.24F, 0.27F}, {0.33F, 0.18F, 0.13F}}};
  const double kind = random.uniform();
  const bool can_slope = style.plan == FloorPlan::kBox && style.floors <= 5 &&
                         std::min(style.width_m, style.depth_m) < 14.0;
  style.roof = !can_slope || kind < 0.4 ? RoofShape::kFlat
                                        : (kind < 0.85 ? RoofShape::kGable : RoofShape::kHip);
  style.roof_pitch = random.uniform(0.5, 0.9);
  style.eaves_m = random.uniform(0.3, 0.65);
  style.parapet_m = random.uniform(0.5, 1.0);
  style.roof_color = style.roof == RoofShape::kFlat
                         ? jittered(kMembranes[random.index(kMembranes.size())], random)
                         : jittered(kTiles[random.index(kTiles.size())], random);
}

}  // namespace

BuildingStyle random_building_style(
    FloorPlan plan, double width_m, double depth_m, float contrast, std::uint64_t seed) {
  Random random(seed, "world/building-style");
  BuildingStyle style;
  style.plan = plan;
  style.width_m = width_m;
  style.depth_m = depth_m;
  style.seed = seed;
  style.contrast = contrast;
  style.floors = plan == FloorPlan::kTower ? 7 + static_cast<int>(random.index(3))
                                           : 2 + static_cast<int>(random.index(4));
  style.floor_height_m = random.uniform(2.8, 3.3);
  style.window_width_m = random.uniform(1.0, 1.7);
  style.window_height_m = random.uniform(1.2, 1.7);
  style.window_spacing_m = random.uniform(2.5, 3.8);
  style.balcony_share = random.uniform() < 0.65 ? random.uniform(0.15, 0.5) : 0.0;
  style.string_courses = random.uniform() < 0.6;
  choose_walls(style, random);
  choose_roof(style, random);
  const double tint = random.uniform();
  style.balcony_color =
      tint < 0.5 ? Eigen::Vector3f::Constant(static_cast<float>(random.uniform(0.3, 0.55)))
                 : jittered({0.42F, 0.34F, 0.14F}, random);
  if (plan == FloorPlan::kTower) style.wall = Material::kBrick;
  return style;
}

}  // namespace hybridfusion
