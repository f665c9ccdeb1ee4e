#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// Continuous-time noise of an IMU, as data sheets and Allan plots give it.
struct ImuNoise {
  double gyro_noise_density = 1e-3;   ///< [rad/s/sqrt(Hz)]
  double accel_noise_density = 1e-2;  ///< [m/s^2/sqrt(Hz)]
  double gyro_bias_walk = 2e-5;       ///< [rad/s^2/sqrt(Hz)]
  double accel_bias_walk = 2e-4;      ///< [m/s^3/sqrt(Hz)]
};

/// What the vehicle knows of itself. The defaults suit a consumer IMU and a LiDAR whose IMU shares
/// its frame.
struct LidarRig {
  Rigid3 imu_from_lidar = {};
  Eigen::Vector3d gnss_antenna_in_imu = Eigen::Vector3d::Zero();  ///< [m]
  ImuNoise imu_noise = {};
};

/// kInvalidOptions for a density that is not positive or an extrinsic that is not finite.
[[nodiscard]] Expected<void> validate(const LidarRig& rig);

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

/// Map that scans are matched against.
struct LocalMapOptions {
  std::string structure = "hash";
  double voxel_m = 0.3;
  double cube_side_m = 1000.0;
};
template <>
struct OptionFields<LocalMapOptions> {
  using T = LocalMapOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::structure,
            {.key = "structure",
             .choices = "hash|ikdtree",
             .doc = "hash: flat hash of voxels that keep the mean of their points, the more "
                    "accurate; ikdtree: incremental k-d tree that keeps the point nearest to "
                    "each voxel's centre, as the paper.",
             .source = "HybridFusion III-B.2; FAST-LIO2, IV"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.05,
             .max = 5.0,
             .doc = "One map point in a voxel of this side.",
             .source = "FAST-LIO2, IV-C"}},
      Field{&T::cube_side_m,
            {.key = "cube_side_m",
             .unit = "m",
             .min = 10.0,
             .max = 20000.0,
             .doc = "Side of the cube of map points that is kept around the sensor; at least three "
                    "times max_range_m.",
             .source = "HybridFusion III-B.2; FAST-LIO2, V-A"}},
  };
};

/// Places passed twice, found when the recording is over.
struct LoopClosureOptions {
  bool enabled = true;
  double min_path_m = 30.0;
  double drift_ratio = 0.01;
  double blind_drift_ratio = 0.1;
  double yaw_drift_radps = 2e-4;
  double max_drift_m = 25.0;
  double min_inlier_share = 0.75;
  int min_support = 2;
  double robust_sigmas = 3.0;
  int max_candidates = 200;
};
template <>
struct OptionFields<LoopClosureOptions> {
  using T = LoopClosureOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Look for places that were passed twice and let their two visits agree.",
             .source = "ours"}},
      Field{&T::min_path_m,
            {.key = "min_path_m",
             .unit = "m",
             .min = 10.0,
             .max = 10000.0,
             .doc = "Shortest way between two visits of a place.",
             .source = "ours"}},
      Field{&T::drift_ratio,
            {.key = "drift_ratio",
             .unit = "m/m",
             .min = 0.0,
             .max = 0.5,
             .doc = "Largest drift for each metre of way: how far around a place loops are "
                    "searched for.",
             .source = "ours"}},
      Field{&T::blind_drift_ratio,
            {.key = "blind_drift_ratio",
             .unit = "m/m",
             .min = 0.0,
             .max = 1.0,
             .doc = "The same, added for way driven while scans were degenerate or unmatched or "
                    "missing.",
             .source = "ours"}},
      Field{&T::yaw_drift_radps,
            {.key = "yaw_drift_radps",
             .unit = "rad/s",
             .min = 0.0,
             .max = 0.1,
             .doc = "Largest drift of the heading.",
             .source = "ours"}},
      Field{&T::max_drift_m,
            {.key = "max_drift_m",
             .unit = "m",
             .min = 1.0,
             .max = 100.0,
             .doc = "Loops are never searched for farther away.",
             .source = "ours"}},
      Field{&T::min_inlier_share,
            {.key = "min_inlier_share",
             .unit = "1",
             .min = 0.3,
             .max = 1.0,
             .doc = "Share of the common surface of two visits that must coincide.",
             .source = "ours"}},
      Field{&T::min_support,
            {.key = "min_support",
             .unit = "1",
             .min = 0,
             .max = 20,
             .doc = "Other loops that must tell the same before a loop counts.",
             .source = "after Mangelson et al. 2018, pairwise consistent measurements"}},
      Field{&T::robust_sigmas,
            {.key = "robust_sigmas",
             .unit = "1",
             .min = 0.5,
             .max = 100.0,
             .doc = "Scale of the Cauchy weight of loops in the pose graph.",
             .source = "after Yang et al. 2020, graduated non-convexity"}},
      Field{&T::max_candidates,
            {.key = "max_candidates",
             .unit = "1",
             .min = 1,
             .max = 100000,
             .doc = "Pairs of places looked at, spread evenly over the drive: bounds the time.",
             .source = "ours"}},
  };
};

/// Offline refinement of the whole trajectory after the last scan.
struct LidarRefineOptions {
  bool enabled = true;
  int iterations = 4;
  double segment_s = 0.5;
  double voxel_m = 0.5;
  double max_plane_sigma_m = 0.05;
  double max_plane_noise_ratio = 1.5;
};
template <>
struct OptionFields<LidarRefineOptions> {
  using T = LidarRefineOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::enabled,
            {.key = "enabled",
             .doc = "Adjust all poses and planes together when the recording is over.",
             .source = "after Liu and Zhang 2021, BALM"}},
      Field{&T::iterations,
            {.key = "iterations",
             .unit = "1",
             .min = 1,
             .max = 50,
             .doc = "Gauss-Newton passes of the adjustment.",
             .source = "ours"}},
      Field{&T::segment_s,
            {.key = "segment_s",
             .unit = "s",
             .min = 0.05,
             .max = 10.0,
             .doc = "Scans of this duration move together.",
             .source = "ours"}},
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.2,
             .max = 10.0,
             .doc = "Side of the cells in which points may form one plane.",
             .source = "ours"}},
      Field{&T::max_plane_sigma_m,
            {.key = "max_plane_sigma_m",
             .unit = "m",
             .min = 0.005,
             .max = 1.0,
             .doc = "Cells whose points scatter more about their plane are not used.",
             .source = "ours"}},
      Field{&T::max_plane_noise_ratio,
            {.key = "max_plane_noise_ratio",
             .unit = "1",
             .min = 1.0,
             .max = 100.0,
             .doc = "Nor are those that scatter more than this times the range noise of the "
                    "sensor, which is found from the scans: they hold edges, leaves or a rough "
                    "surface, of which each visit samples another part.",
             .source = "ours"}},
  };
};

/// Dense map that is handed on.
struct DenseMapOptions {
  double voxel_m = 0.1;
  int min_scans = 2;
  double max_brief_s = 3.0;
  int min_rays_through = 2;
  double max_range_m = 80.0;
};
template <>
struct OptionFields<DenseMapOptions> {
  using T = DenseMapOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::voxel_m,
            {.key = "voxel_m",
             .unit = "m",
             .min = 0.01,
             .max = 5.0,
             .doc = "One point (the mean) in a voxel of this side.",
             .source = "ours"}},
      Field{&T::min_scans,
            {.key = "min_scans",
             .unit = "1",
             .min = 1,
             .max = 100,
             .doc = "A voxel stays when it and its neighbours were hit in this many scans: drops "
                    "stray returns.",
             .source = "ours"}},
      Field{&T::max_brief_s,
            {.key = "max_brief_s",
             .unit = "s",
             .min = 0.0,
             .max = 3600.0,
             .doc = "A voxel above the ground that was hit for no longer than this moved when rays "
                    "of other scans went through it: it is dropped. 0: keep what moves.",
             .source = "after Schauer and Nuechter 2018, the people remover"}},
      Field{&T::min_rays_through,
            {.key = "min_rays_through",
             .unit = "1",
             .min = 1,
             .max = 100,
             .doc = "Scans that must have seen through such a voxel.",
             .source = "ours"}},
      Field{&T::max_range_m,
            {.key = "max_range_m",
             .unit = "m",
             .min = 1.0,
             .max = 1000.0,
             .doc = "Points measured from farther away are left out of the dense map.",
             .source = "ours"}},
  };
};

/// LiDAR-inertial odometry and mapping.
struct OdometryOptions {
  double min_range_m = 1.0;
  double max_range_m = 100.0;
  double imu_time_offset_s = 0.0;
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
