#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/geometry/ground.hpp>
#include <hybridfusion/registration/drift.hpp>
#include <hybridfusion/registration/paper_options.hpp>
#include <hybridfusion/registration/patch_vote_options.hpp>

#include <numbers>
#include <string>

namespace hybridfusion {

/// Outline maps of both clouds seen from above, and the search of one over the other.
struct OutlineOptions {
  double cut_share = 0.003;  ///< Points cut off on each side before a raster is laid.
  double lidar_cell_m = 0.5;
  int min_facade_bins = 4;  ///< Occupied 0.5 m height bins above 1 m of a facade column.
  double min_edge_m = 2.0;  ///< Height step of a roof rim.
  double interior_margin_m = 1.2;
  double max_ground_m = 0.6;
  double max_ground_spread_m = 0.35;  ///< Of a vision ground cell.
  double max_free_spread_m = 0.3;     ///< Of a LiDAR ground cell.
  double search_cell_m = 1.0;
  double search_blur_m = 1.0;
  double refine_cell_m = 0.5;
  double refine_blur_m = 0.6;
  double yaw_step_rad = std::numbers::pi / 180.0;
  double free_penalty = 0.5;  ///< Weight of open ground that falls on buildings.
  int num_peaks = 8;
  double peak_distance_m = 5.0;
  double peak_angle_rad = 6.0 * std::numbers::pi / 180.0;
  double min_overhang_m = -0.25;
  double max_overhang_m = 1.75;
};

template <>
struct OptionFields<OutlineOptions> {
  using T = OutlineOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::cut_share,
            {.key = "cut_share",
             .unit = "1",
             .min = 0.0,
             .max = 0.1,
             .doc = "Share of the points cut off on each side of a cloud before rasters are laid.",
             .source = "ours"}},
      Field{&T::lidar_cell_m,
            {.key = "lidar_cell_m",
             .unit = "m",
             .min = 0.1,
             .max = 5.0,
             .doc = "Cell of the LiDAR facade and free-ground maps.",
             .source = "ours"}},
      Field{&T::min_facade_bins,
            {.key = "min_facade_bins",
             .unit = "bins",
             .min = 1.0,
             .max = 60.0,
             .doc = "Occupied 0.5 m height bins above 1 m that make a column a facade.",
             .source = "ours"}},
      Field{&T::min_edge_m,
            {.key = "min_edge_m",
             .unit = "m",
             .min = 0.2,
             .max = 20.0,
             .doc = "Height step in the vision cloud that makes a rim.",
             .source = "ours"}},
      Field{&T::interior_margin_m,
            {.key = "interior_margin_m",
             .unit = "m",
             .min = 0.0,
             .max = 10.0,
             .doc = "Building cells nearer to a rim do not count as interior.",
             .source = "ours"}},
      Field{&T::max_ground_m,
            {.key = "max_ground_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "Largest height over the ground surface of a ground cell.",
             .source = "ours"}},
      Field{&T::max_ground_spread_m,
            {.key = "max_ground_spread_m",
             .unit = "m",
             .min = 0.02,
             .max = 5.0,
             .doc = "Largest height range inside a vision ground cell.",
             .source = "ours"}},
      Field{&T::max_free_spread_m,
            {.key = "max_free_spread_m",
             .unit = "m",
             .min = 0.02,
             .max = 5.0,
             .doc = "Largest height range inside a LiDAR free-ground cell.",
             .source = "ours"}},
      Field{&T::search_cell_m,
            {.key = "search_cell_m",
             .unit = "m",
             .min = 0.25,
             .max = 5.0,
             .doc = "Raster of the exhaustive search.",
             .source = "ours"}},
      Field{&T::search_blur_m,
            {.key = "search_blur_m",
             .unit = "m",
             .min = 0.05,
             .max = 10.0,
             .doc = "Blur of the rims in the exhaustive search.",
             .source = "ours"}},
      Field{&T::refine_cell_m,
            {.key = "refine_cell_m",
             .unit = "m",
             .min = 0.1,
             .max = 5.0,
             .doc = "Raster of the refinement of every peak.",
             .source = "ours"}},
      Field{&T::refine_blur_m,
            {.key = "refine_blur_m",
             .unit = "m",
             .min = 0.05,
             .max = 10.0,
             .doc = "Blur of the rims there.",
             .source = "ours"}},
      Field{&T::yaw_step_rad,
            {.key = "yaw_step_rad",
             .unit = "rad",
             .min = 0.001,
             .max = 0.2,
             .doc = "Heading step of the exhaustive search.",
             .source = "ours"}},
      Field{&T::free_penalty,
            {.key = "free_penalty",
             .unit = "1",
             .min = 0.0,
             .max = 10.0,
             .doc = "Weight of free LiDAR ground that falls inside vision buildings.",
             .source = "ours"}},
      Field{&T::num_peaks,
            {.key = "num_peaks",
             .unit = "peaks",
             .min = 2.0,
             .max = 100.0,
             .doc = "Peaks of the search that are refined.",
             .source = "ours"}},
      Field{&T::peak_distance_m,
            {.key = "peak_distance_m",
             .unit = "m",
             .min = 0.5,
             .max = 100.0,
             .doc = "Peaks nearer than this (and in heading) are one.",
             .source = "ours"}},
      Field{&T::peak_angle_rad,
            {.key = "peak_angle_rad",
             .unit = "rad",
             .min = 0.01,
             .max = 1.0,
             .doc = "Peaks nearer than this (and in position) are one.",
             .source = "ours"}},
      Field{&T::min_overhang_m,
            {.key = "min_overhang_m",
             .unit = "m",
             .min = -5.0,
             .max = 0.0,
             .doc = "Least outward shift of facades onto rims.",
             .source = "ours"}},
      Field{
          &T::max_overhang_m,
          {.key = "max_overhang_m",
           .unit = "m",
           .min = 0.0,
           .max = 5.0,
           .doc = "Largest outward shift of facades onto rims: roof overhang and stereo fattening.",
           .source = "ours"}},
  };
};

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
  };
};

/// Normal distributions transform in 3D, the `ndt` baseline.
struct NdtOptions {
  double start_cell_m = 4.0;
  double final_cell_m = 1.5;
  int iterations = 40;
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
