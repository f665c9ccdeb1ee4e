#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Normal distributions transform in 3D, the `ndt` baseline.
struct NdtOptions {
  double start_cell_m = 4.0;
  double final_cell_m = 1.5;
  int iterations = 200;
  int min_cell_points = 6;
  double outlier_ratio = 0.55;
  int samples = 30000;
};

template <>
struct OptionFields<NdtOptions> {
  using T = NdtOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::start_cell_m,
            {.key = "start_cell_m",
             .unit = "m",
             .min = 0.2,
             .max = 50.0,
             .doc = "Cell of the first pass.",
             .source = "ours"}},
      Field{&T::final_cell_m,
            {.key = "final_cell_m",
             .unit = "m",
             .min = 0.2,
             .max = 50.0,
             .doc = "Cell of the last pass.",
             .source = "ours"}},
      Field{&T::iterations,
            {.key = "iterations",
             .unit = "1",
             .min = 1.0,
             .max = 1000.0,
             .doc = "Newton steps of each pass.",
             .source = "ours"}},
      Field{&T::min_cell_points,
            {.key = "min_cell_points",
             .unit = "points",
             .min = 4.0,
             .max = 1e6,
             .doc = "Cells with fewer points have no distribution.",
             .source = "Magnusson 2009, 6.2"}},
      Field{&T::outlier_ratio,
            {.key = "outlier_ratio",
             .unit = "1",
             .min = 0.01,
             .max = 0.99,
             .doc = "Share of outliers in the mixture.",
             .source = "Magnusson 2009, Eq. (6.8); PCL default"}},
      Field{&T::samples,
            {.key = "samples",
             .unit = "points",
             .min = 100.0,
             .max = 1e8,
             .doc = "LiDAR points used.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
