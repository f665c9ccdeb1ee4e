#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Dense map that is handed on.
struct DenseMapOptions {
  double voxel_m = 0.1;
  int min_scans = 2;
  double max_brief_s = 3.0;
  int min_rays_through = 2;
  double max_range_m = 80.0;
};
template <>
struct OptionFields<DenseMapOptions> {
  using T = DenseMapOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.01,
             .max = 5.0,
             .doc = "One point (the mean) in a voxel of this side.",
             .source = "ours"}},
      Field{&T::min_scans,
            {.key = "min_scans",
             .unit = "1",
             .min = 1,
             .max = 100,
             .doc = "A voxel stays when it and those within three voxels were hit in this many "
                    "scans: drops stray returns.",
             .source = "ours"}},
      Field{&T::max_brief_s,
            {.key = "max_brief_s",
             .unit = "s",
             .min = 0.0,
             .max = 3600.0,
             .doc = "A voxel above the ground that was hit for no longer than this moved when rays "
                    "of other scans went through it: it is dropped. 0: keep what moves.",
             .source = "after Schauer and Nuechter 2018, the people remover"}},
      Field{&T::min_rays_through,
            {.key = "min_rays_through",
             .unit = "1",
             .min = 1,
             .max = 100,
             .doc = "Scans that must have seen through such a voxel.",
             .source = "ours"}},
      Field{&T::max_range_m,
            {.key = "max_range_m",
             .unit = "m",
             .min = 1.0,
             .max = 1000.0,
             .doc = "Points measured from farther away are left out of the dense map.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
