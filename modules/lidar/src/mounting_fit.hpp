#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

namespace hybridfusion {

/// What IMU and LiDAR each measured from one scan to the next, in the IMU frame as given by
/// imu_from_lidar.
struct MotionPair {
  double duration_s = 0.0;
  Eigen::Vector3d turn_by_gyro_rad = Eigen::Vector3d::Zero();   ///< Rotation vector.
  Eigen::Vector3d turn_by_lidar_rad = Eigen::Vector3d::Zero();  ///< Rotation vector.
  Eigen::Vector3d force_mps2 = Eigen::Vector3d::Zero();         ///< Mean specific force.
  Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero();  ///< By the LiDAR poses.
  Eigen::Matrix3d map_from_imu = Eigen::Matrix3d::Identity();   ///< By the LiDAR poses.
};

/// How the axes in which the IMU measures are turned against those it was said to have.
struct MountingFit {
  Eigen::Matrix3d given_from_measured = Eigen::Matrix3d::Identity();
  bool mirrored = false;      ///< Axes of the wrong handedness explain it better than any turn.
  double gyro_scale = 1.0;    ///< True rate over measured rate.
  double error_before = 0.0;  ///< Share of turns and forces that the given mounting leaves over.
  double error_after = 0.0;   ///< The same with the fit.
};

/// Rotation between the two sets of axes by all turns and forces of a drive at once (Wahba's
/// problem, solved by singular value decomposition: Markley 1988). The vertical, which forces need,
/// is the axis about which the vehicle turned. Nothing when the drive turned too little to tell, or
/// nothing explains what was measured.
[[nodiscard]] std::optional<MountingFit> fit_mounting(std::span<const MotionPair> pairs);

/// "rotated by 90 degrees about x", "mirrored", ...
[[nodiscard]] std::string mounting_text(const MountingFit& fit);

}  // namespace hybridfusion
