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

/// Filter state, time and map: what a scan is processed against. Copyable, so that a start can be
/// tried.
class ScanFilter {
 public:
  ScanFilter(const OdometryOptions& options,
             const LidarRig& rig,
             const StateEstimate& initial,
             Timestamp time);

  /// Predicts to the end of the scan, updates with its points and adds them to the map.
  [[nodiscard]] ScanEstimate process(const PreparedScan& scan, const ImuBuffer& imu);

  [[nodiscard]] Timestamp time() const { return time_; }
  [[nodiscard]] const LocalMap& map() const { return map_; }
  [[nodiscard]] const StateEstimate& estimate() const { return estimate_; }

 private:
  void predict(const ImuBuffer& imu, ScanEstimate& scan);
  [[nodiscard]] ImuStep bridged(ImuStep step) const;
  void extend_map(const std::vector<LidarPoint>& deskewed);

  OdometryOptions options_;
  ImuNoise noise_;
  StateEstimate estimate_;
  Timestamp time_;
  LocalMap map_;
  Eigen::Vector3d rate_radps_ = Eigen::Vector3d::Zero();  // over the last scan, from the poses
  Eigen::Vector3d cube_center_ = Eigen::Vector3d::Zero();
};

}  // namespace hybridfusion
