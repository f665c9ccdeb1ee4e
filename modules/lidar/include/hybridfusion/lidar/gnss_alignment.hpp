#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

struct GnssAlignmentOptions {
  double default_sigma_m = 2.0;
  double outlier_sigmas = 4.0;
  double max_yaw_sigma_rad = 0.07;
  double max_time_gap_s = 0.25;
};
template <>
struct OptionFields<GnssAlignmentOptions> {
  using T = GnssAlignmentOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::default_sigma_m,
            {.key = "default_sigma_m",
             .unit = "m",
             .min = 0.001,
             .max = 100.0,
             .doc = "Deviation of a fix whose message does not say.",
             .source = "ours"}},
      Field{&T::outlier_sigmas,
            {.key = "outlier_sigmas",
             .unit = "1",
             .min = 1.0,
             .max = 20.0,
             .doc = "Fixes farther from the aligned track than this many deviations are left out.",
             .source = "ours"}},
      Field{&T::max_yaw_sigma_rad,
            {.key = "max_yaw_sigma_rad",
             .unit = "rad",
             .min = 1e-4,
             .max = 3.0,
             .doc = "A heading less certain than this is refused.",
             .source = "ours"}},
      Field{&T::max_time_gap_s,
            {.key = "max_time_gap_s",
             .unit = "s",
             .min = 0.0,
             .max = 10.0,
             .doc = "A fix this far outside the trajectory still counts; its pose is held.",
             .source = "ours"}},
  };
};

/// A fix against the aligned track.
struct GnssResidual {
  Timestamp time{};
  Eigen::Vector3d enu_m = Eigen::Vector3d::Zero();  ///< Fix minus antenna, east north up.
  bool used = false;                                ///< False: an outlier.
};

struct GnssAlignment {
  Rigid3 enu_from_map = {};  ///< Yaw and translation only: both frames are level.
  double yaw_rad = 0.0;
  /// Of [east, north, up, yaw] (m, rad), the constant part of the GNSS error included.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double rms_horizontal_m = 0.0;  ///< Of the fixes used, per point.
  double rms_vertical_m = 0.0;
  std::size_t num_used = 0;
  std::size_t num_outliers = 0;
  double track_extent_m = 0.0;  ///< Largest horizontal distance between two antenna positions.
  /// Not empty when fixes and trajectory are of different shape, so that nothing else here means
  /// anything: two in five fixes are off by more than five deviations, 5 m and a twentieth of the
  /// track.
  std::string contradiction = {};
  std::vector<GnssResidual> residuals = {};
};

/// Fits the antenna track of a level trajectory to GNSS fixes: yaw and translation, robust against
/// outliers (least median of squares, then reweighted least squares).
/// @param trajectory          map_from_imu.
/// @param origin              Of the ENU frame.
/// @param antenna_in_imu      Lever arm [m].
/// @returns kInsufficient for fewer than 5 usable fixes within the trajectory; kDegenerate when the
/// track is too short for its noise to give a heading.
[[nodiscard]] Expected<GnssAlignment> align_gnss(const Trajectory& trajectory,
                                                 std::span<const GnssFix> fixes,
                                                 const GeodeticOrigin& origin,
                                                 const Eigen::Vector3d& antenna_in_imu,
                                                 const GnssAlignmentOptions& options);

}  // namespace hybridfusion
