#pragma once

#include <hybridfusion/core/options.hpp>

#include <numbers>

namespace hybridfusion {

/// Patches of the LiDAR cloud registered one by one near a pose that was found: the voting of
/// HybridFusion III-C, as a check.
struct PatchVoteOptions {
  bool enabled = true;
  int grid_divisions = 10;
  double min_facade_weight = 8.0;
  double max_shift_m = 1.5;
  double max_turn_rad = std::numbers::pi / 60.0;
  double min_overlap_share = 0.5;
  double cluster_radius_m = 0.6;
  double cluster_angle_rad = std::numbers::pi / 90.0;
};

template <>
struct OptionFields<PatchVoteOptions> {
  using T = PatchVoteOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Register patches of the LiDAR cloud near the pose and count how many agree.",
             .source = "ours, after HybridFusion III-C.5"}},
      Field{&T::grid_divisions,
            {.key = "grid_divisions",
             .unit = "patches",
             .min = 2.0,
             .max = 100.0,
             .doc = "The patch step is the size of the vision scene divided by this.",
             .source = "HybridFusion III-C.1, one tenth"}},
      Field{
          &T::min_facade_weight,
          {.key = "min_facade_weight",
           .unit = "columns",
           .min = 1.0,
           .max = 1e6,
           .doc = "Patches with fewer facade columns of 0.5 m (neighbours included) have no vote.",
           .source = "ours"}},
      Field{&T::max_shift_m,
            {.key = "max_shift_m",
             .unit = "m",
             .min = 0.05,
             .max = 20.0,
             .doc = "A patch that moves further votes against the pose.",
             .source = "ours"}},
      Field{&T::max_turn_rad,
            {.key = "max_turn_rad",
             .unit = "rad",
             .min = 0.001,
             .max = 0.5,
             .doc = "A patch that turns further votes against the pose.",
             .source = "ours"}},
      Field{&T::min_overlap_share,
            {.key = "min_overlap_share",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Share of the facades of a patch that must lie over known vision ground or "
                    "roof for it to have a vote.",
             .source = "ours"}},
      Field{&T::cluster_radius_m,
            {.key = "cluster_radius_m",
             .unit = "m",
             .min = 0.01,
             .max = 20.0,
             .doc = "Largest gap between the moves of two patches that agree (epsilon).",
             .source = "HybridFusion III-C.5, epsilon; value ours"}},
      Field{&T::cluster_angle_rad,
            {.key = "cluster_angle_rad",
             .unit = "rad",
             .min = 0.001,
             .max = 0.5,
             .doc = "Largest angle between the turns of two patches that agree (omega).",
             .source = "HybridFusion III-C.5, omega; value ours"}},
  };
};

}  // namespace hybridfusion
