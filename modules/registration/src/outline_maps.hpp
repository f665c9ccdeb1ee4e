#pragma once

#include "raster.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/registration/registration_options.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// What the photo cloud says about outlines, seen from above.
struct VisionMaps {
  Raster height;  ///< 80th percentile of the height above ground [m]; unknown where empty.
  Raster edge;    ///< Rims of what stands 2 m above its surroundings, blurred; a straight rim is 1.
  Raster interior;  ///< 1 well inside what is higher than 2 m, else 0.
  Raster ground_z;  ///< Median z [m] of flat, low cells; unknown elsewhere.
};
/// @param heights  Above ground [m], one per point.
[[nodiscard]] VisionMaps make_vision_maps(std::span<const Eigen::Vector3f> points,
                                          std::span<const float> heights,
                                          double cell_m,
                                          double blur_m,
                                          const OutlineOptions& options);

/// A column of LiDAR points that reaches high: part of a facade.
struct FacadeCell {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();     ///< Of the points above 1 m [m].
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< Unit, to the free side; zero if unknown.
  double weight = 0.0;
};

/// What the LiDAR cloud says about outlines.
struct LidarMaps {
  std::vector<FacadeCell> facades = {};
  std::vector<Eigen::Vector3d> free_cells = {};  ///< Mean x, y and median z of open, flat ground.
  double facade_weight = 0.0;                    ///< Sum over `facades`.
  double linear_share = 0.0;  ///< Share of facade weight before reduction that lies on lines.
};
[[nodiscard]] LidarMaps make_lidar_maps(std::span<const Eigen::Vector3f> points,
                                        std::span<const float> heights,
                                        const OutlineOptions& options);

/// Box [low, high] in x-y that holds all but `share` of the points on each side.
struct Box2 {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
};
[[nodiscard]] Box2 percentile_box(std::span<const Eigen::Vector3f> points, double share);

}  // namespace hybridfusion
