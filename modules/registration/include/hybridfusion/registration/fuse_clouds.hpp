#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/gap_interpolation.hpp>

#include <cstddef>
#include <optional>

namespace hybridfusion {

/// How two registered clouds become one.
struct FuseOptions {
  bool drop_duplicates = true;
  double search_m = 0.5;
  int min_neighbors = 4;
  double min_distance_m = 0.15;
  double sigma_factor = 2.5;
  double fill_gap_m = 0.05;
  double default_vision_sigma_m = 0.06;
  double default_lidar_sigma_m = 0.01;
  double color_distance_m = 0.3;
  InterpolationOptions interpolation = {};
};

template <>
struct OptionFields<FuseOptions> {
  using T = FuseOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::drop_duplicates,
            {.key = "drop_duplicates",
             .doc = "Where both clouds show one surface, keep the better one.",
             .source = "ours"}},
      Field{&T::search_m,
            {.key = "search_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "Neighbourhood in which the other cloud must show a surface.",
             .source = "ours"}},
      Field{&T::min_neighbors,
            {.key = "min_neighbors",
             .unit = "points",
             .min = 3.0,
             .max = 100.0,
             .doc = "Points of the other cloud that make a surface there.",
             .source = "ours"}},
      Field{&T::min_distance_m,
            {.key = "min_distance_m",
             .unit = "m",
             .min = 0.0,
             .max = 2.0,
             .doc = "Points nearer than this to the better surface are the same surface.",
             .source = "ours"}},
      Field{&T::sigma_factor,
            {.key = "sigma_factor",
             .unit = "1",
             .min = 0.0,
             .max = 10.0,
             .doc = "... or nearer than this many standard deviations of both.",
             .source = "ours"}},
      Field{&T::fill_gap_m,
            {.key = "fill_gap_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "A double that lies further than this beside the nearest point of the better "
                    "surface fills a gap there: it stays and is moved onto that surface.",
             .source = "ours"}},
      Field{&T::default_vision_sigma_m,
            {.key = "default_vision_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 5.0,
             .doc = "Standard deviation of vision points that carry none.",
             .source = "ours"}},
      Field{&T::default_lidar_sigma_m,
            {.key = "default_lidar_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 5.0,
             .doc = "Standard deviation of LiDAR points that carry none.",
             .source = "ours"}},
      Field{
          &T::color_distance_m,
          {.key = "color_distance_m",
           .unit = "m",
           .min = 0.0,
           .max = 100.0,
           .doc = "LiDAR points take the colour of the nearest vision point within this distance; "
                  "others are mid-grey.",
           .source = "ours"}},
      Field{&T::interpolation,
            {.key = "interpolation", .doc = "Narrow gaps between the points of a surface."}},
  };
};

struct FuseResult {
  PointCloud cloud = {};  ///< In the vision frame; `sources` is filled.
  std::size_t vision_dropped = 0;
  std::size_t lidar_dropped = 0;
  std::size_t interpolated = 0;  ///< The last ones of `cloud`.
};

/// Maps the LiDAR cloud into the vision frame and merges both (HybridFusion III, module C). A point
/// is dropped when the other cloud is the better one there (smaller sigma) and shows the same
/// surface: no double walls, no thick ground. One that lies in a gap between the points of the
/// better cloud stays and is moved onto their plane, so that the merge is nowhere thinner than
/// either cloud. Channels survive when both clouds have them; LiDAR
/// points without colours borrow those of near vision points; intensities survive from the LiDAR
/// cloud alone (vision points get 0). Narrow gaps are filled by interpolate_gaps, behind all
/// measured points and marked by their source. Clouds that are moved in are not copied.
/// @param vision_rescale  When given, applied to the vision cloud first (e.g. the scale that the
///                        LiDAR corrects); `vision_from_lidar` then refers to the rescaled cloud.
/// @returns kInvalidOptions, or kInsufficient when a cloud's channels are inconsistent.
[[nodiscard]] Expected<FuseResult> fuse_clouds(PointCloud vision,
                                               PointCloud lidar,
                                               const Rigid3& vision_from_lidar,
                                               const std::optional<Sim3>& vision_rescale = {},
                                               const FuseOptions& options = {},
                                               const RunContext& ctx = {});

}  // namespace hybridfusion
