#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// The scene: a street block (or a grid of them) on sloping ground.
struct WorldOptions {
  std::string variant = "town";
  double size_m = 80.0;
  int blocks_x = 1;
  int blocks_y = 1;
  int main_building = 0;
  double texture_contrast = 1.0;
  double relief_m = 1.0;
  double tree_spacing_m = 12.0;
  int ambient_rays = 40;
  std::string mesh = {};
};
template <>
struct OptionFields<WorldOptions> {
  using T = WorldOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::variant,
            {.key = "variant",
             .choices = "town|dull|repetitive|flat|other-site|tunnel",
             .doc = "town; dull: weak texture; repetitive: identical facades; flat: a field with "
                    "nothing to register on; other-site: the street drive happens in another "
                    "world than the flight; tunnel: a straight road tunnel of length size_m.",
             .source = "ours"}},
      Field{&T::size_m,
            {.key = "size_m",
             .unit = "m",
             .min = 40,
             .max = 400,
             .doc = "Width of one block with its streets and the houses across.",
             .source = "ours"}},
      Field{&T::blocks_x,
            {.key = "blocks_x",
             .unit = "1",
             .min = 1,
             .max = 12,
             .doc = "Blocks along the first "
                    "street direction.",
             .source = "ours"}},
      Field{&T::blocks_y,
            {.key = "blocks_y",
             .unit = "1",
             .min = 1,
             .max = 12,
             .doc = "Blocks along the second "
                    "street direction.",
             .source = "ours"}},
      Field{&T::main_building,
            {.key = "main_building",
             .unit = "1",
             .min = 0,
             .max = 4,
             .doc = "One main building in the block: 1 slab, 2 L, 3 U, 4 tower on a base; 0: a "
                    "random group.",
             .source = "HybridFusion Table I"}},
      Field{&T::texture_contrast,
            {.key = "texture_contrast",
             .unit = "1",
             .min = 0.05,
             .max = 2,
             .doc = "Scale of all albedo variation.",
             .source = "ours"}},
      Field{&T::relief_m,
            {.key = "relief_m",
             .unit = "m",
             .min = 0,
             .max = 10,
             .doc = "Height of the ground's slope and waves over one block.",
             .source = "ours"}},
      Field{&T::tree_spacing_m,
            {.key = "tree_spacing_m",
             .unit = "m",
             .min = 4,
             .max = 1000,
             .doc = "Mean distance of the trees along a pavement.",
             .source = "ours"}},
      Field{&T::ambient_rays,
            {.key = "ambient_rays",
             .unit = "1",
             .min = 4,
             .max = 1024,
             .doc = "Rays per vertex when the ambient occlusion is baked.",
             .source = "ours"}},
      Field{
          &T::mesh,
          {.key = "mesh",
           .doc =
               "PLY mesh (metres, z up) to photograph and scan instead of a generated block; it is "
               "set on flat ground with streets around it.",
           .source = "ours"}},
  };
};

}  // namespace hybridfusion
