#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// Places passed twice, found when the recording is over.
struct LoopClosureOptions {
  bool enabled = true;
  double min_path_m = 30.0;
  double drift_ratio = 0.01;
  double blind_drift_ratio = 0.1;
  double yaw_drift_radps = 2e-4;
  double max_drift_m = 25.0;
  double min_inlier_share = 0.75;
  int min_support = 2;
  double robust_sigmas = 3.0;
  int max_candidates = 200;
};
template <>
struct OptionFields<LoopClosureOptions> {
  using T = LoopClosureOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Look for places that were passed twice and let their two visits agree.",
             .source = "ours"}},
      Field{&T::min_path_m,
            {.key = "min_path_m",
             .unit = "m",
             .min = 10.0,
             .max = 10000.0,
             .doc = "Shortest way between two visits of a place.",
             .source = "ours"}},
      Field{&T::drift_ratio,
            {.key = "drift_ratio",
             .unit = "m/m",
             .min = 0.0,
             .max = 0.5,
             .doc = "Largest drift for each metre of way: how far around a place loops are "
                    "searched for.",
             .source = "ours"}},
      Field{&T::blind_drift_ratio,
            {.key = "blind_drift_ratio",
             .unit = "m/m",
             .min = 0.0,
             .max = 1.0,
             .doc = "The same, added for way driven while scans were degenerate or unmatched or "
                    "missing.",
             .source = "ours"}},
      Field{&T::yaw_drift_radps,
            {.key = "yaw_drift_radps",
             .unit = "rad/s",
             .min = 0.0,
             .max = 0.1,
             .doc = "Largest drift of the heading.",
             .source = "ours"}},
      Field{&T::max_drift_m,
            {.key = "max_drift_m",
             .unit = "m",
             .min = 1.0,
             .max = 100.0,
             .doc = "Loops are never searched for farther away.",
             .source = "ours"}},
      Field{&T::min_inlier_share,
            {.key = "min_inlier_share",
             .unit = "1",
             .min = 0.3,
             .max = 1.0,
             .doc = "Share of the common surface of two visits that must coincide.",
             .source = "ours"}},
      Field{&T::min_support,
            {.key = "min_support",
             .unit = "1",
             .min = 0,
             .max = 20,
             .doc = "Other loops that must tell the same before a loop counts.",
             .source = "after Mangelson et al. 2018, pairwise consistent measurements"}},
      Field{&T::robust_sigmas,
            {.key = "robust_sigmas",
             .unit = "1",
             .min = 0.5,
             .max = 100.0,
             .doc = "Scale of the Cauchy weight of loops in the pose graph.",
             .source = "after Yang et al. 2020, graduated non-convexity"}},
      Field{&T::max_candidates,
            {.key = "max_candidates",
             .unit = "1",
             .min = 1,
             .max = 100000,
             .doc = "Pairs of places looked at, spread evenly over the drive: bounds the time.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
