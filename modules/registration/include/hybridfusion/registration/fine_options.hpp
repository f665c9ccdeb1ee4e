#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Point-to-plane alignment of facades and ground around a good pose.
struct FineOptions {
  int samples = 24000;  ///< LiDAR points, half of them on facades where possible.
  int neighbors = 20;   ///< For the planes of both clouds.
  double max_curvature = 0.06;
  double min_normal_cosine = 0.9;
  double start_gate_m = 1.5;
  double final_gate_m = 0.3;
  int iterations = 10;
  int min_vertical_pairs = 200;   ///< Fewer: x, y and heading are left alone.
  double max_scale_error = 0.01;  ///< |s - 1| above which a scale is not believed.
  bool estimate_scale = true;
};

template <>
struct OptionFields<FineOptions> {
  using T = FineOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::samples,
            {.key = "samples",
             .unit = "points",
             .min = 100.0,
             .max = 1e7,
             .doc = "LiDAR points used, half of them vertical where there are enough.",
             .source = "ours"}},
      Field{&T::neighbors,
            {.key = "neighbors",
             .unit = "points",
             .min = 5.0,
             .max = 200.0,
             .doc = "Neighbours that define a local plane.",
             .source = "ours"}},
      Field{&T::max_curvature,
            {.key = "max_curvature",
             .unit = "1",
             .min = 0.001,
             .max = 0.34,
             .doc = "Surface variation above which a point has no plane.",
             .source = "ours"}},
      Field{&T::min_normal_cosine,
            {.key = "min_normal_cosine",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Planes of a pair agree at least this well.",
             .source = "ours"}},
      Field{&T::start_gate_m,
            {.key = "start_gate_m",
             .unit = "m",
             .min = 0.05,
             .max = 20.0,
             .doc = "Largest pair distance at the start.",
             .source = "ours"}},
      Field{&T::final_gate_m,
            {.key = "final_gate_m",
             .unit = "m",
             .min = 0.02,
             .max = 5.0,
             .doc = "Largest pair distance at the end.",
             .source = "ours"}},
      Field{&T::iterations,
            {.key = "iterations",
             .unit = "1",
             .min = 2.0,
             .max = 500.0,
             .doc = "Iterations while the gate shrinks.",
             .source = "ours"}},
      Field{&T::min_vertical_pairs,
            {.key = "min_vertical_pairs",
             .unit = "pairs",
             .min = 0.0,
             .max = 1e6,
             .doc = "With fewer facade pairs x, y and heading stay as the outlines gave them.",
             .source = "ours"}},
      Field{&T::max_scale_error,
            {.key = "max_scale_error",
             .unit = "1",
             .min = 0.0,
             .max = 0.1,
             .doc = "A vision scale further from 1 is not believed.",
             .source = "ours"}},
      Field{&T::estimate_scale,
            {.key = "estimate_scale",
             .doc = "Estimate the scale of the vision cloud as a 7th parameter.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
