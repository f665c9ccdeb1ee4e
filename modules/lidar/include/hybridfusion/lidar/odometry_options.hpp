#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/lidar/dense_map_options.hpp>
#include <hybridfusion/lidar/filter_options.hpp>
#include <hybridfusion/lidar/local_map_options.hpp>
#include <hybridfusion/lidar/loop_closure_options.hpp>
#include <hybridfusion/lidar/refinement_options.hpp>

namespace hybridfusion {

/// LiDAR-inertial odometry and mapping.
struct OdometryOptions {
  double min_range_m = 1.0;
  double max_range_m = 100.0;
  double imu_time_offset_s = 0.0;
  int max_odometry_points = 40000;
  int max_points_per_scan = 12000;
  double max_blind_s = 5.0;
  LidarInitOptions init = {};
  LidarFilterOptions filter = {};
  LocalMapOptions local_map = {};
  LoopClosureOptions loop_closure = {};
  LidarRefineOptions refine = {};
  DenseMapOptions map = {};
};
template <>
struct OptionFields<OdometryOptions> {
  using T = OdometryOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::min_range_m,
            {.key = "min_range_m",
             .unit = "m",
             .min = 0.0,
             .max = 100.0,
             .doc = "Nearer returns (the vehicle itself) are dropped.",
             .source = "FAST-LIO2 (blind)"}},
      Field{&T::max_range_m,
            {.key = "max_range_m",
             .unit = "m",
             .min = 1.0,
             .max = 1000.0,
             .doc = "Farther returns are dropped.",
             .source = "FAST-LIO2 (detection range)"}},
      Field{&T::imu_time_offset_s,
            {.key = "imu_time_offset_s",
             .unit = "s",
             .min = -10.0,
             .max = 10.0,
             .doc = "Added to the IMU stamps to bring them onto the LiDAR clock.",
             .source = "ours"}},
      Field{&T::max_odometry_points,
            {.key = "max_odometry_points",
             .unit = "1",
             .min = 1000,
             .max = 1e7,
             .doc = "Of denser scans every n-th point is used.",
             .source = "ours; on 64-line drives a quarter of the points gives the same path"}},
      Field{&T::max_points_per_scan,
            {.key = "max_points_per_scan",
             .unit = "1",
             .min = 100,
             .max = 1e7,
             .doc = "Denser scans keep every n-th point for refinement and dense map (12 bytes a "
                    "point are held until the end).",
             .source = "ours"}},
      Field{&T::max_blind_s,
            {.key = "max_blind_s",
             .unit = "s",
             .min = 0.5,
             .max = 1e6,
             .doc = "A longer time without a scan that is located by its points makes the map "
                    "unreliable (exit code 4).",
             .source = "ours"}},
      Field{&T::init, {.key = "init", .doc = "First state."}},
      Field{&T::filter, {.key = "filter", .doc = "Kalman filter."}},
      Field{&T::local_map, {.key = "local_map", .doc = "Map for matching."}},
      Field{&T::loop_closure, {.key = "loop_closure", .doc = "Places passed twice."}},
      Field{&T::refine, {.key = "refine", .doc = "Offline refinement."}},
      Field{&T::map, {.key = "map", .doc = "Dense map."}},
  };
};

/// Ranges of the table, and cube_side_m >= 3 max_range_m, min_range_m < max_range_m.
[[nodiscard]] Expected<void> validate_odometry(const OdometryOptions& options);

}  // namespace hybridfusion
