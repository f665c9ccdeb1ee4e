#pragma once

#include <hybridfusion/core/options.hpp>

#include <string>

namespace hybridfusion {

/// Semi-global matching of a rectified pair.
struct StereoOptions {
  std::string matcher = "sgm";
  std::string backend = "auto";
  bool diagonal_paths = false;
  int smoothness_small = 10;
  int smoothness_large = 60;
  double uniqueness = 0.03;
  double max_left_right_px = 1.0;
  double min_texture_grey = 1.0;
  int min_segment_px = 100;
  double max_vertical_parallax_px = 1.0;
  double disparity_sigma_px = 0.25;
  int max_volume_mib = 192;
};

template <>
struct OptionFields<StereoOptions> {
  using T = StereoOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::matcher,
          {.key = "matcher",
           .choices = "sgm|sgbm",
           .doc = "sgm: census semi-global matching, coarse to fine. sgbm: OpenCV's, block based; "
                  "quicker on textured ground, invents surfaces on sky and blank walls.",
           .source = "HybridFusion III-A.2; Hirschmueller 2008"}},
      Field{&T::backend,
            {.key = "backend",
             .choices = "auto|cpu|cuda",
             .doc = "Where matcher sgm runs. auto: on a CUDA device when the program was built for "
                    "one (HF_CUDA) and there is one, else on the CPU; cuda: the same, with a "
                    "warning instead of silence. The disparities are the same.",
             .source = "HybridFusion III-A.2 (CUDA)"}},
      Field{&T::diagonal_paths,
            {.key = "diagonal_paths",
             .doc = "Costs are aggregated along eight paths instead of four, at nearly twice the "
                    "time.",
             .source = "Hirschmueller 2008, 2.3; value ours"}},
      Field{&T::smoothness_small,
            {.key = "smoothness_small",
             .unit = "bits",
             .min = 0,
             .max = 200,
             .doc = "Cost of a disparity step of one pixel between neighbours (P1).",
             .source = "Hirschmueller 2008, Eq. 13; value ours"}},
      Field{&T::smoothness_large,
            {.key = "smoothness_large",
             .unit = "bits",
             .min = 1,
             .max = 1000,
             .doc = "Cost of a larger disparity step (P2), lowered at grey edges.",
             .source = "Hirschmueller 2008, Eq. 13; value ours"}},
      Field{&T::uniqueness,
            {.key = "uniqueness",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "The second best disparity must cost more by this share.",
             .source = "ours"}},
      Field{&T::max_left_right_px,
            {.key = "max_left_right_px",
             .unit = "px",
             .min = 0.0,
             .max = 10.0,
             .doc = "Largest gap between the disparities found from either image.",
             .source = "Hirschmueller 2008, 2.4"}},
      Field{&T::min_texture_grey,
            {.key = "min_texture_grey",
             .unit = "grey",
             .min = 0.0,
             .max = 255.0,
             .doc = "Standard deviation of the matching window below which nothing is matched: sky "
                    "and blank walls.",
             .source = "ours"}},
      Field{&T::min_segment_px,
            {.key = "min_segment_px",
             .unit = "px",
             .min = 0,
             .max = 1e6,
             .doc = "Smaller islands of disparity are dropped.",
             .source = "Hirschmueller 2008, 2.5"}},
      Field{
          &T::max_vertical_parallax_px,
          {.key = "max_vertical_parallax_px",
           .unit = "px",
           .min = 0.1,
           .max = 100.0,
           .doc = "A pair whose features leave their rows by more (median) is left out: its poses "
                  "or its camera model are wrong. Sound pairs have 0.1 to 0.3 px.",
           .source = "ours"}},
      Field{
          &T::disparity_sigma_px,
          {.key = "disparity_sigma_px",
           .unit = "px",
           .min = 0.01,
           .max = 10.0,
           .doc = "Standard deviation of a refined disparity, from which the points' sigmas start.",
           .source = "ours, from errors against true surfaces"}},
      Field{&T::max_volume_mib,
            {.key = "max_volume_mib",
             .unit = "MiB",
             .min = 1,
             .max = 100000,
             .doc = "Costs of one pair in memory, a thread; larger pairs are matched in strips of "
                    "rows, with the same result and about half as much work again.",
             .source = "ours"}},
  };
};

/// Which depths survive: agreement between depth maps and of colours.
struct DepthCheckOptions {
  double max_relative_depth = 0.01;
  double max_disparity_px = 1.5;
  int min_supporting_views = 1;
  double min_correlation = 0.5;
  int trusted_views = 2;
  double edge_step = 0.02;
  int edge_margin_px = 2;
  int sky_reach_px = 16;
};

template <>
struct OptionFields<DepthCheckOptions> {
  using T = DepthCheckOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_relative_depth,
            {.key = "max_relative_depth",
             .unit = "1",
             .min = 0.0,
             .max = 0.2,
             .doc = "Depths of two photos agree within this share of the depth or within "
                    "max_disparity_px, whichever is smaller.",
             .source = "HybridFusion III-A.2 (depth consistency); value ours"}},
      Field{&T::max_disparity_px,
            {.key = "max_disparity_px",
             .unit = "px",
             .min = 0.1,
             .max = 10.0,
             .doc = "The same, as a change of disparity.",
             .source = "ours"}},
      Field{&T::min_supporting_views,
            {.key = "min_supporting_views",
             .unit = "photos",
             .min = 1,
             .max = 10,
             .doc = "Other depth maps, or further stereo partners of the photo, that must agree "
                    "with a depth.",
             .source = "HybridFusion III-A.2; value ours"}},
      Field{&T::min_correlation,
            {.key = "min_correlation",
             .unit = "1",
             .min = -1.0,
             .max = 1.0,
             .doc = "Correlation (ZNCC, 5 x 5 pixels) that at least one other photo must reach.",
             .source = "HybridFusion III-A.2 (photometric consistency); value ours"}},
      Field{&T::trusted_views,
            {.key = "trusted_views",
             .unit = "photos",
             .min = 1,
             .max = 1000,
             .doc = "A depth that this many others agree with, and none sees through, needs no "
                    "correlation: three photos err alike too seldom.",
             .source = "ours, from errors against true surfaces"}},
      Field{&T::edge_step,
            {.key = "edge_step",
             .unit = "1",
             .min = 0.0,
             .max = 1.0,
             .doc = "Relative depth step that counts as an object's edge.",
             .source = "ours"}},
      Field{
          &T::edge_margin_px,
          {.key = "edge_margin_px",
           .unit = "px",
           .min = 0,
           .max = 20,
           .doc = "Depths this near to an edge are dropped: the matching window mixes both sides.",
           .source = "ours"}},
      Field{&T::sky_reach_px,
            {.key = "sky_reach_px",
             .unit = "px",
             .min = 0,
             .max = 200,
             .doc = "Pixels this near to the sky that have its colour get no depth; 0: all keep "
                    "theirs. Photos without a horizon have no sky.",
             .source = "ours"}},
  };
};

/// Dense reconstruction from posed photos.
struct DensifyOptions {
  int max_size_px = 1350;
  int num_neighbors = 3;
  double min_angle_deg = 3.0;
  double max_angle_deg = 30.0;
  double best_angle_deg = 12.0;
  double voxel_m = 0.0;
  int min_points_per_voxel = 2;
  double max_gsd_ratio = 3.0;
  int max_memory_mib = 512;
  StereoOptions stereo = {};
  DepthCheckOptions check = {};
};

template <>
struct OptionFields<DensifyOptions> {
  using T = DensifyOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_size_px,
            {.key = "max_size_px",
             .unit = "px",
             .min = 200,
             .max = 10000,
             .doc = "Photos are matched at this longest side (never enlarged).",
             .source = "ours"}},
      Field{&T::num_neighbors,
            {.key = "num_neighbors",
             .unit = "photos",
             .min = 1,
             .max = 10,
             .doc = "Photos that each photo is matched with.",
             .source = "HybridFusion III-A.2 (stereo pairs of larger baseline); value ours"}},
      Field{&T::min_angle_deg,
            {.key = "min_angle_deg",
             .unit = "deg",
             .min = 0.1,
             .max = 90.0,
             .doc = "Smallest median intersection angle of a pair.",
             .source = "ours"}},
      Field{&T::max_angle_deg,
            {.key = "max_angle_deg",
             .unit = "deg",
             .min = 1.0,
             .max = 90.0,
             .doc = "Largest median intersection angle of a pair.",
             .source = "ours"}},
      Field{&T::best_angle_deg,
            {.key = "best_angle_deg",
             .unit = "deg",
             .min = 1.0,
             .max = 90.0,
             .doc = "Preferred median intersection angle of a pair.",
             .source = "ours"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "Spacing of the fused cloud; 0: twice the median ground sampling distance.",
             .source = "ours"}},
      Field{&T::min_points_per_voxel,
            {.key = "min_points_per_voxel",
             .unit = "points",
             .min = 1,
             .max = 100,
             .doc = "Voxels with fewer depths are dropped, except where photos sample a surface so "
                    "thinly that its other voxels hold few as well.",
             .source = "ours"}},
      Field{
          &T::max_gsd_ratio,
          {.key = "max_gsd_ratio",
           .unit = "1",
           .min = 1.0,
           .max = 100.0,
           .doc = "Depths beyond this many times the median depth are dropped (far oblique field).",
           .source = "ours"}},
      Field{&T::max_memory_mib,
            {.key = "max_memory_mib",
             .unit = "MiB",
             .min = 64,
             .max = 1e6,
             .doc = "Photos and depth maps kept in memory; depth maps beyond lie on disk while the "
                    "cloud is made, photos are decoded again.",
             .source = "ours"}},
      Field{&T::stereo, {.key = "stereo", .doc = "Stereo matching."}},
      Field{&T::check, {.key = "check", .doc = "Consistency between photos."}},
  };
};

}  // namespace hybridfusion
