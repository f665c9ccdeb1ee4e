#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <array>
#include <cstddef>

namespace hybridfusion::benchmark {

/// Lengths of way over which a relative error is taken [m].
inline constexpr std::array<double, 4> kSegments_m = {5.0, 10.0, 25.0, 50.0};

/// Mean error of the motion over segments of one length; < 0: the drive is shorter.
struct SegmentError {
  std::size_t num_segments = 0;
  double translation_percent = -1.0;  ///< Of the length.
  /// The same after the one turn between the bodies that fits best: an error of calibration or of
  /// the reference's heading meets every estimate alike and would hide what differs.
  double turned_percent = -1.0;
  double rotation_deg = -1.0;
};

/// An estimated drive against a reference of the same body on the same clock.
struct DriveErrors {
  std::size_t num_poses = 0;  ///< Within the reference's time.
  double path_m = 0.0;        ///< Of the reference.
  double path_ratio = 0.0;    ///< Estimated length over that of the reference.
  double ate_m = 0.0;         ///< After the best rigid alignment.
  double ate_max_m = 0.0;
  double tilt_deg = 0.0;  ///< Angle between the ups after the best turn about the vertical, rms.
  double misalignment_deg = 0.0;  ///< The turn of `turned_percent`.
  std::array<SegmentError, kSegments_m.size()> segments = {};
  Rigid3 reference_from_map = {};  ///< The alignment.
};

/// @returns kInsufficient below 3 common poses.
[[nodiscard]] Expected<DriveErrors> drive_errors(const Trajectory& reference,
                                                 const Trajectory& estimate);

/// Median over cubes of 1 m with a plane in them of the points' deviation from it [m]; < 0: none.
[[nodiscard]] double plane_thickness_m(const PointCloud& cloud);

}  // namespace hybridfusion::benchmark
