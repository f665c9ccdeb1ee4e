#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// Map that scans are matched against.
struct LocalMapOptions {
  std::string structure = "hash";
  double voxel_m = 0.3;
  double cube_side_m = 1000.0;
};
template <>
struct OptionFields<LocalMapOptions> {
  using T = LocalMapOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::structure,
            {.key = "structure",
             .choices = "hash|ikdtree",
             .doc = "hash: flat hash of voxels that keep the mean of their points, the more "
                    "accurate; ikdtree: incremental k-d tree that keeps the point nearest to "
                    "each voxel's centre, as the paper.",
             .source = "HybridFusion III-B.2; FAST-LIO2, IV"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "One map point in a voxel of this side.",
             .source = "FAST-LIO2, IV-C"}},
      Field{&T::cube_side_m,
            {.key = "cube_side_m",
             .unit = "m",
             .min = 10.0,
             .max = 20000.0,
             .doc = "Side of the cube of map points that is kept around the sensor; at least three "
                    "times max_range_m.",
             .source = "HybridFusion III-B.2; FAST-LIO2, V-A"}},
  };
};

}  // namespace hybridfusion
