#pragma once

#include <hybridfusion/lidar/odometry.hpp>

#include <deque>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Watches whether the turns of the gyro fit those of the located scans. What is left over after a
/// span of scans, r = Log(R_lidar^T R_gyro), would be
///   phi x theta   for a mounting that is off by theta (phi the turn of the span), and
///   -(w_end - w_begin) d   for IMU stamps that need d added,
/// besides what the gyro bias leaves. One running least-squares fit; a few numbers of memory.
class RigCheck {
 public:
  void add(const ScanEstimate& scan);

  /// Sentences for what is evidently wrong (five sigma and far more than a good rig is off).
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  static constexpr int kSize = 7;  // theta, d, bias
  struct Entry {
    Eigen::Quaterniond map_from_imu = Eigen::Quaterniond::Identity();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // by the gyro, since the entry before
    double duration_s = 0.0;
  };

  std::deque<Entry> recent_ = {};
  Eigen::Matrix<double, kSize, kSize> normal_ = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> right_ = Eigen::Matrix<double, kSize, 1>::Zero();
  double squares_ = 0.0;
  int num_spans_ = 0;
};

}  // namespace hybridfusion
