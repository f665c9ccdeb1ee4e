#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

/// How the first state is found.
struct LidarInitOptions {
  double standstill_s = 1.0;
  double max_wait_s = 3.0;
  double max_gyro_std_radps = 0.01;
  double max_accel_std_mps2 = 0.15;
};
template <>
struct OptionFields<LidarInitOptions> {
  using T = LidarInitOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::standstill_s,
            {.key = "standstill_s",
             .unit = "s",
             .min = 0.2,
             .max = 10.0,
             .doc = "Shortest standstill that levels the map and gives the gyro bias.",
             .source = "ours"}},
      Field{&T::max_wait_s,
            {.key = "max_wait_s",
             .unit = "s",
             .min = 0.5,
             .max = 20.0,
             .doc = "Data looked at for the start; without a standstill in it the start is found "
                    "in motion.",
             .source = "ours"}},
      Field{&T::max_gyro_std_radps,
            {.key = "max_gyro_std_radps",
             .unit = "rad/s",
             .min = 0.0,
             .max = 1.0,
             .doc = "Largest gyro deviation of a standstill, besides three times the noise.",
             .source = "ours"}},
      Field{&T::max_accel_std_mps2,
            {.key = "max_accel_std_mps2",
             .unit = "m/s^2",
             .min = 0.0,
             .max = 10.0,
             .doc = "Largest accelerometer deviation of a standstill, besides three times the "
                    "noise.",
             .source = "ours"}},
  };
};

/// Iterated error-state Kalman filter.
struct LidarFilterOptions {
  double scan_voxel_m = 0.5;
  int max_iterations = 4;
  double point_sigma_m = 0.03;
  double max_plane_offset_m = 0.1;
  double neighbor_radius_m = 1.5;
  double rematch_distance_m = 0.1;
  int min_matches = 30;
  double min_information_ratio = 0.001;
  double max_correction_m = 1.5;
  bool estimate_extrinsic = false;
};
template <>
struct OptionFields<LidarFilterOptions> {
  using T = LidarFilterOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::scan_voxel_m,
            {.key = "scan_voxel_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "A scan is thinned to one point in a voxel of this side before matching.",
             .source = "FAST-LIO2 (Xu et al. 2022), V-A"}},
      Field{&T::max_iterations,
            {.key = "max_iterations",
             .unit = "1",
             .min = 1,
             .max = 20,
             .doc = "Passes of the iterated update.",
             .source = "FAST-LIO2, Algorithm 1"}},
      Field{&T::point_sigma_m,
            {.key = "point_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 1.0,
             .doc = "Standard deviation of a point-to-plane residual.",
             .source = "FAST-LIO2, Eq. (14); value ours"}},
      Field{&T::max_plane_offset_m,
            {.key = "max_plane_offset_m",
             .unit = "m",
             .min = 0.01,
             .max = 1.0,
             .doc = "Neighbours farther off their plane than this do not make a plane.",
             .source = "FAST-LIO2, V-B"}},
      Field{&T::neighbor_radius_m,
            {.key = "neighbor_radius_m",
             .unit = "m",
             .min = 0.1,
             .max = 10.0,
             .doc = "The five map points of a plane lie within this distance.",
             .source = "FAST-LIO2, V-B; value ours"}},
      Field{&T::rematch_distance_m,
            {.key = "rematch_distance_m",
             .unit = "m",
             .min = 0.0,
             .max = 5.0,
             .doc = "Planes are searched again when a pass moved the farthest matched point by "
                    "more than this.",
             .source = "ours"}},
      Field{&T::min_matches,
            {.key = "min_matches",
             .unit = "1",
             .min = 6,
             .max = 1e6,
             .doc = "With fewer matched points the prediction is kept and the scan is flagged.",
             .source = "ours"}},
      Field{&T::min_information_ratio,
            {.key = "min_information_ratio",
             .unit = "1",
             .min = 0.0,
             .max = 0.3,
             .doc = "A direction in which the mean squared cosine of the plane normals is below "
                    "this is held to the prediction.",
             .source = "after Zhang et al. 2016, degeneracy of optimization"}},
      Field{&T::max_correction_m,
            {.key = "max_correction_m",
             .unit = "m",
             .min = 0.05,
             .max = 100.0,
             .doc = "An update that moves the prediction farther is refused, unless the "
                    "prediction is that uncertain (three sigma).",
             .source = "ours"}},
      Field{&T::estimate_extrinsic,
            {.key = "estimate_extrinsic",
             .doc = "Refine imu_from_lidar along with the motion.",
             .source = "FAST-LIO2, IV-A"}},
  };
};

}  // namespace hybridfusion
