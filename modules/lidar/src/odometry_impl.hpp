#pragma once

#include "imu_buffer.hpp"
#include "imu_watch.hpp"
#include "initialization.hpp"
#include "mounting_fit.hpp"
#include "rig_check.hpp"
#include "scan_filter.hpp"
#include "start_motion.hpp"

#include <hybridfusion/lidar/odometry.hpp>

#include <deque>
#include <optional>

namespace hybridfusion {

struct LidarOdometry::Impl {
  OdometryOptions options;
  LidarRig rig;
  ImuBuffer imu = {};
  std::deque<PreparedScan> waiting = {};
  std::optional<ScanFilter> filter = {};
  RigCheck rig_check = {};
  std::vector<ScanEstimate> done = {};
  OdometrySummary summary = {};
  Timestamp last_end{};
  Timestamp shift{};
  double typical_period_s = 0.0;
  double typical_span_s = 0.0;
  int num_accepted = 0;
  int num_late = 0;
  bool clock_stepped = false;
  /// While the IMU is there but not believed: to find out why.
  std::vector<MotionPair> motion_pairs = {};
  std::optional<ScanEstimate> last_scan = {};
  ImuWatch imu_watch = {};
  int num_start_attempts = 0;
  /// Of the scan at the front of `waiting`, so that it is worked out once.
  std::optional<StartMotion> start_motion = {};

  PreparedScan prepare(LidarScan scan);
  bool accept(PreparedScan& scan);
  void note_period(PreparedScan& scan);
  void drain(bool last);
  void process_front();
  // odometry_watch.cpp
  void watch_imu(const ScanEstimate& scan);
  void compare_motion(const ScanEstimate& scan);
  void name_imu_fault();

  // odometry_start.cpp
  [[nodiscard]] bool wants_imu() const;
  /// False while more data is needed; may drop scans from the front of `waiting`.
  bool try_start(bool last);
  bool start_with_imu(bool last);
  bool start_moving(bool last);
  [[nodiscard]] StartMotion motion_of_first_scans();
  [[nodiscard]] bool lidar_stands_still();
  [[nodiscard]] std::vector<ScanEstimate> follow_without_imu(const StartMotion& motion,
                                                             Timestamp until) const;
  void postpone_start();
};

}  // namespace hybridfusion
