#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// What a pose must show to be believed. Between a limit and its doubtful value confidence falls.
struct VerdictOptions {
  double min_confidence = 0.5;
  double max_peak_ratio = 0.85;
  double doubtful_peak_ratio = 0.75;
  double max_ridge_ratio = 0.9;
  double min_facade_weight = 25.0;
  double min_facade_share = 0.5;
  double min_linear_share = 0.1;
  double min_ground_share = 0.6;
  double max_free_violations = 0.12;
  double max_facade_on_ground = 0.25;
  double max_sigma_m = 0.5;
  double min_patch_share = 0.05;
  double min_facade_support = 0.65;
};

template <>
struct OptionFields<VerdictOptions> {
  using T = VerdictOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::min_confidence,
            {.key = "min_confidence",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Below this product of the evidence the pose is refused.",
             .source = "ours"}},
      Field{&T::max_peak_ratio,
            {.key = "max_peak_ratio",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Second best over best outline score above which the place is ambiguous.",
             .source = "ours"}},
      Field{&T::doubtful_peak_ratio,
            {.key = "doubtful_peak_ratio",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Ratio from which confidence falls; below max_peak_ratio.",
             .source = "ours"}},
      Field{&T::max_ridge_ratio,
            {.key = "max_ridge_ratio",
             .unit = "1",
             .min = 0.2,
             .max = 1.0,
             .doc = "Score 3 m beside the best place over its own above which a direction is free.",
             .source = "ours"}},
      Field{&T::min_facade_weight,
            {.key = "min_facade_weight",
             .unit = "columns",
             .min = 1.0,
             .max = 1e6,
             .doc = "Facade columns (weighted) that must lie on rims; full confidence from 2.4 "
                    "times as many.",
             .source = "ours"}},
      Field{&T::min_facade_share,
            {.key = "min_facade_share",
             .unit = "1",
             .min = 0.0,
             .max = 0.75,
             .doc = "Share of the facades over the vision cloud that must lie on rims; full "
                    "confidence 0.25 above.",
             .source = "ours"}},
      Field{&T::min_linear_share,
            {.key = "min_linear_share",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Share of LiDAR columns on straight walls below which there are only trees.",
             .source = "ours"}},
      Field{&T::min_ground_share,
            {.key = "min_ground_share",
             .unit = "1",
             .min = 0.0,
             .max = 0.99,
             .doc = "Share of LiDAR ground that must lie within 0.2 m of vision ground.",
             .source = "ours"}},
      Field{&T::max_free_violations,
            {.key = "max_free_violations",
             .unit = "1",
             .min = 0.001,
             .max = 1.0,
             .doc = "Share of LiDAR ground that may lie inside vision buildings.",
             .source = "ours"}},
      Field{&T::max_facade_on_ground,
            {.key = "max_facade_on_ground",
             .unit = "1",
             .min = 0.001,
             .max = 1.0,
             .doc = "Share of facades that may stand on open vision ground.",
             .source = "ours"}},
      Field{&T::max_sigma_m,
            {.key = "max_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 10.0,
             .doc = "Largest standard deviation of the position at the scene.",
             .source = "ours"}},
      Field{&T::min_patch_share,
            {.key = "min_patch_share",
             .unit = "1",
             .min = 0.0,
             .max = 0.5,
             .doc = "Share of the LiDAR patches that must stay at the pose when registered alone; "
                    "full confidence from twice that. 0: their votes have no say.",
             .source = "ours, after HybridFusion III-C.5"}},
      Field{&T::min_facade_support,
            {.key = "min_facade_support",
             .unit = "1",
             .min = 0.0,
             .max = 0.9,
             .doc = "Share of the LiDAR facades on surfaces of the vision cloud from which these "
                    "may decide between places alike in outline; full confidence 0.1 above.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
