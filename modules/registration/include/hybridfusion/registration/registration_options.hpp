#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/geometry/ground.hpp>
#include <hybridfusion/registration/drift.hpp>
#include <hybridfusion/registration/fine_options.hpp>
#include <hybridfusion/registration/ndt_options.hpp>
#include <hybridfusion/registration/outline_options.hpp>
#include <hybridfusion/registration/paper_options.hpp>
#include <hybridfusion/registration/patch_vote_options.hpp>
#include <hybridfusion/registration/verdict_options.hpp>

#include <numbers>
#include <string>

namespace hybridfusion {

/// Cross-source registration (HybridFusion III-C).
struct RegistrationOptions {
  std::string method = "hybrid";
  double max_offset_m = 20.0;
  double max_yaw_rad = std::numbers::pi / 6.0;
  double voxel_m = 0.2;
  double max_range_m = 80.0;
  GroundOptions ground = {};
  OutlineOptions outline = {};
  FineOptions fine = {};
  PatchVoteOptions votes = {};
  DriftOptions drift = {};
  VerdictOptions verdict = {};
  NdtOptions ndt = {};
  PaperOptions paper = {};
};

template <>
struct OptionFields<RegistrationOptions> {
  using T = RegistrationOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::method,
            {.key = "method",
             .choices = "hybrid|paper|gicp|ndt",
             .doc = "hybrid: outline search and fine alignment; paper: the published chain; "
                    "gicp, ndt: baselines; all but hybrid start from the coarse pose.",
             .source = "ours"}},
      Field{&T::max_offset_m,
            {.key = "max_offset_m",
             .unit = "m",
             .min = 0.0,
             .max = 1e5,
             .doc = "How far a given coarse pose may be off horizontally; without one the search "
                    "has no limit.",
             .source = "ours"}},
      Field{&T::max_yaw_rad,
            {.key = "max_yaw_rad",
             .unit = "rad",
             .min = 0.0,
             .max = std::numbers::pi,
             .doc = "How far the heading of the coarse pose (identity without one) may be off; pi: "
                    "unknown.",
             .source = "ours"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.02,
             .max = 5.0,
             .doc = "Both clouds are reduced to one mean per voxel.",
             .source = "HybridFusion III-C.1; value ours"}},
      Field{&T::max_range_m,
            {.key = "max_range_m",
             .unit = "m",
             .min = 1.0,
             .max = 1e4,
             .doc = "LiDAR points further from the given sensor positions are left out.",
             .source = "ours"}},
      Field{&T::ground, {.key = "ground", .doc = "Ground surfaces."}},
      Field{&T::outline, {.key = "outline", .doc = "Outline maps and search."}},
      Field{&T::fine, {.key = "fine", .doc = "Fine alignment."}},
      Field{&T::votes, {.key = "votes", .doc = "Votes of LiDAR patches on the pose."}},
      Field{&T::drift, {.key = "drift", .doc = "Drift of the LiDAR cloud."}},
      Field{&T::verdict, {.key = "verdict", .doc = "When a pose is believed."}},
      Field{&T::ndt, {.key = "ndt", .doc = "NDT baseline."}},
      Field{&T::paper, {.key = "paper", .doc = "The published chain."}},
  };
};

}  // namespace hybridfusion
