#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/geometry/ground.hpp>

#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Boundary of a 2D point set by the angular gap criterion (HybridFusion III-C.4 and IV-A).
struct BoundaryOptions {
  double radius_m = 1.0;                        ///< Neighbourhood.
  double min_gap_rad = std::numbers::pi / 2.0;  ///< Empty sector that makes a boundary point.
  double thin_m = 0.2;                          ///< The input is thinned to one mean per cell.
  double min_height_m = 2.0;                    ///< Of elevated_boundary: what is not ground.
};

template <>
struct OptionFields<BoundaryOptions> {
  using T = BoundaryOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::radius_m,
            {.key = "radius_m",
             .unit = "m",
             .min = 0.05,
             .max = 20.0,
             .doc = "Neighbourhood of the angular gap criterion.",
             .source = "HybridFusion III-C.4; value ours"}},
      Field{&T::min_gap_rad,
            {.key = "min_gap_rad",
             .unit = "rad",
             .min = 0.1,
             .max = 6.3,
             .doc = "Empty sector that makes a point a boundary point.",
             .source = "PCL BoundaryEstimation, 90 deg"}},
      Field{&T::thin_m,
            {.key = "thin_m",
             .unit = "m",
             .min = 0.01,
             .max = 5.0,
             .doc = "Cell of the 2D thinning before the gaps are looked for.",
             .source = "ours"}},
      Field{&T::min_height_m,
            {.key = "min_height_m",
             .unit = "m",
             .min = -100.0,
             .max = 100.0,
             .doc = "Points lower above ground are left out (h).",
             .source = "HybridFusion III-C.4, d > h; value ours"}},
  };
};

/// Widest sector [rad] between consecutive directions [rad], which are sorted in place; a full turn
/// for one. @pre !directions.empty()
[[nodiscard]] float widest_gap_rad(std::vector<float>& directions);

/// Thins `points` to cell means (ascending cell order) and keeps those with an empty sector wider
/// than `min_gap_rad` among their neighbours within `radius_m`. Points with fewer than two
/// neighbours have no boundary to speak of and are dropped. Non-finite points are ignored.
[[nodiscard]] std::vector<Eigen::Vector2f> boundary_points(std::span<const Eigen::Vector2f> points,
                                                           const BoundaryOptions& options = {},
                                                           const RunContext& ctx = {});

/// Projects the points higher than `min_height_m` above `ground` to x-y and takes their boundary.
[[nodiscard]] std::vector<Eigen::Vector2f> elevated_boundary(
    std::span<const Eigen::Vector3f> points,
    const GroundModel& ground,
    const BoundaryOptions& options = {},
    const RunContext& ctx = {});

}  // namespace hybridfusion
