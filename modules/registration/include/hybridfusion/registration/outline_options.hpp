#pragma once

#include <hybridfusion/core/options.hpp>

#include <numbers>

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

}  // namespace hybridfusion
