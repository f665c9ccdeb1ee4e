#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/evaluation/boundary_accuracy.hpp>

#include <string>

namespace hybridfusion {

struct EvaluationOptions {
  double leaf_m = 0.5;
  BoundaryAccuracyOptions boundary = {};
  std::string baselines = "gicp";
  double drive_radius_m = 80.0;
  int max_points = 500000;
};

template <>
struct OptionFields<EvaluationOptions> {
  using T = EvaluationOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::leaf_m,
            {.key = "leaf_m",
             .unit = "m",
             .min = 0.01,
             .max = 100.0,
             .doc = "Octree leaf of the headline supplement degree; 0.2, 0.5 and 1 m are always "
                    "reported too.",
             .source = "HybridFusion IV-A; value ours"}},
      Field{&T::boundary,
            {.key = "boundary", .doc = "Boundary accuracy.", .source = "HybridFusion IV-A"}},
      Field{&T::baselines,
            {.key = "baselines",
             .choices = "none|gicp|all",
             .doc = "Baselines run beside ours from the same coarse alignment; all: gicp, ndt and "
                    "the published chain.",
             .source = "HybridFusion IV, Table I"}},
      Field{&T::drive_radius_m,
            {.key = "drive_radius_m",
             .unit = "m",
             .min = 1.0,
             .max = 10000.0,
             .doc = "The true registration is fitted to LiDAR points this near to the drive.",
             .source = "ours"}},
      Field{
          &T::max_points,
          {.key = "max_points",
           .unit = "points",
           .min = 1000,
           .max = 1e9,
           .doc = "Points of a cloud whose distance to the true surface is measured, evenly taken.",
           .source = "ours"}},
  };
};

}  // namespace hybridfusion
