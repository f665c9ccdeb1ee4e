#pragma once

#include "imu_buffer.hpp"
#include "imu_propagation.hpp"
#include "local_map.hpp"

#include <hybridfusion/lidar/odometry.hpp>

namespace hybridfusion {

/// A scan after cleaning: valid points in ascending time.
struct PreparedScan {
  Timestamp stamp{};  ///< Offsets count from here.
  Timestamp begin{};  ///< First point.
  Timestamp end{};    ///< Last point.
  std::vector<LidarPoint> points = {};
  std::uint32_t flags = 0;  ///< ScanFlag bits.
};

/// What predicts the motion from one scan to the next.
enum class MotionModel : std::uint8_t {
  kInertial,         ///< The IMU.
  kConstantVelocity  ///< Velocity and turn rate go on: no IMU, or none that is believed.
};

/// Filter state, time and map: what a scan is processed against. Copyable, so that a start can be
/// tried.
class ScanFilter {
 public:
  ScanFilter(const OdometryOptions& options,
             const LidarRig& rig,
             const StateEstimate& initial,
             Timestamp time,
             MotionModel model);

  /// Predicts to the end of the scan, updates with its points and adds them to the map.
  /// @param imu  Not looked at with kConstantVelocity.
  [[nodiscard]] ScanEstimate process(const PreparedScan& scan, const ImuBuffer& imu);

  /// Goes on with constant velocity: the IMU is no longer believed.
  void leave_imu();

  [[nodiscard]] Timestamp time() const { return time_; }
  [[nodiscard]] MotionModel model() const { return model_; }
  [[nodiscard]] const LocalMap& map() const { return map_; }
  [[nodiscard]] const StateEstimate& estimate() const { return estimate_; }

 private:
  [[nodiscard]] std::vector<ImuStep> steps(const ImuBuffer& imu,
                                           Timestamp begin,
                                           Timestamp end) const;
  [[nodiscard]] ImuNoise noise(const ImuBuffer& imu) const;
  void predict(const ImuBuffer& imu, ScanEstimate& scan);
  [[nodiscard]] ImuStep bridged(ImuStep step) const;
  void extend_map(const std::vector<LidarPoint>& deskewed);

  OdometryOptions options_;
  MotionModel model_;
  ImuNoise noise_;
  StateEstimate estimate_;
  Timestamp time_;
  LocalMap map_;
  Eigen::Vector3d rate_radps_ = Eigen::Vector3d::Zero();  // over the last scan, from the poses
  Eigen::Vector3d cube_center_ = Eigen::Vector3d::Zero();
};

}  // namespace hybridfusion
