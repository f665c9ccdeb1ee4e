#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <numbers>

namespace hybridfusion {

/// Which gaps between the points of a surface are filled, and how.
struct InterpolationOptions {
  bool enabled = true;
  double spacing_m = 0.1;
  double radius_m = 0.4;
  int min_neighbors = 5;
  double max_open_angle_rad = 170.0 / 180.0 * std::numbers::pi;
  double max_roughness_m = 0.12;
};

template <>
struct OptionFields<InterpolationOptions> {
  using T = InterpolationOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Fill narrow gaps with interpolated points (source 2); false keeps measured "
                    "points only.",
             .source = "ours"}},
      Field{&T::spacing_m,
            {.key = "spacing_m",
             .unit = "m",
             .min = 0.02,
             .max = 5.0,
             .doc = "Distance between interpolated points, and the least one to a measured point.",
             .source = "ours"}},
      Field{&T::radius_m,
            {.key = "radius_m",
             .unit = "m",
             .min = 0.05,
             .max = 20.0,
             .doc = "Neighbourhood that must show the surface: wider gaps stay open.",
             .source = "ours"}},
      Field{&T::min_neighbors,
            {.key = "min_neighbors",
             .unit = "points",
             .min = 4.0,
             .max = 24.0,
             .doc = "Points of the surface around an interpolated one.",
             .source = "ours"}},
      Field{&T::max_open_angle_rad,
            {.key = "max_open_angle_rad",
             .unit = "rad",
             .min = 0.5,
             .max = std::numbers::pi,
             .doc = "Widest sector without a neighbour: below a half turn nothing is extrapolated.",
             .source = "after PCL BoundaryEstimation; value ours"}},
      Field{&T::max_roughness_m,
            {.key = "max_roughness_m",
             .unit = "m",
             .min = 0.001,
             .max = 5.0,
             .doc = "Weighted rms distance of the neighbours from their plane; rougher places stay "
                    "open.",
             .source = "ours"}},
  };
};

/// Points on the surface between measured ones: where no point lies within `spacing_m` but
/// neighbours within `radius_m` surround the place, their weighted plane is sampled (the projection
/// of moving least squares, Alexa et al. 2003, of first order). Colour is the neighbours' weighted
/// mean, other channels those of the nearest point, `sources` kInterpolated; sigma joins that of
/// the neighbours and their rms distance from the plane. Nothing is added beyond the rim of a
/// surface or across a gap wider than about `radius_m`.
/// @param cloud  Finite points; every channel it has the result has too, and `sources`, `sigmas_m`.
/// @returns The added points alone, in the order of their cells. Incomplete when `ctx` is stopped.
[[nodiscard]] PointCloud interpolate_gaps(const PointCloud& cloud,
                                          const InterpolationOptions& options = {},
                                          const RunContext& ctx = {});

}  // namespace hybridfusion
