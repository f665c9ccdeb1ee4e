#include "odometry_impl.hpp"

#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Eigen::Vector3d turn_between(const ScanEstimate& a, const ScanEstimate& b) {
  return so3_log(
      (a.map_from_imu.rotation.conjugate() * b.map_from_imu.rotation).toRotationMatrix());
}

std::string matrix_text(const Eigen::Matrix4d& m) {
  std::string text;
  for (int i = 0; i < 16; ++i) {
    text += fmt::format("{}{:.4g}", i == 0 ? "" : ", ", m(i / 4, i % 4) + 0.0);
  }
  return text;
}

}  // namespace

void LidarOdometry::Impl::watch_imu(const ScanEstimate& scan) {
  if (rig.imu_use == ImuUse::kNone || imu.empty()) return;
  if (filter->model() == MotionModel::kInertial) {
    if (const auto doubt = imu_watch.add(scan)) {
      summary.imu_doubts.push_back(fmt::format("from scan {} on {}", summary.num_scans, *doubt));
      filter->leave_imu();
    }
  } else {
    compare_motion(scan);
  }
  last_scan = scan;
  last_scan->deskewed.clear();
}

void LidarOdometry::Impl::compare_motion(const ScanEstimate& scan) {
  constexpr auto kBlind = static_cast<std::uint32_t>(ScanFlag::kUnmatched);
  if (!last_scan || imu.last_time() < scan.time || (scan.quality.flags & kBlind) != 0) return;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  MotionPair pair{.duration_s = to_seconds(scan.time - last_scan->time)};
  if (!(pair.duration_s > 0.0)) return;
  for (const ImuStep& step : imu.steps(last_scan->time, scan.time)) {
    if (step.bridged) return;
    turn = turn * so3_exp(step.dt_s * step.angular_velocity_radps);
    pair.force_mps2 += step.dt_s / pair.duration_s * step.specific_force_mps2;
  }
  pair.turn_by_gyro_rad = so3_log(turn);
  pair.turn_by_lidar_rad = turn_between(*last_scan, scan);
  pair.map_from_imu = scan.map_from_imu.rotation.toRotationMatrix();
  pair.acceleration_mps2 = pair.map_from_imu.transpose() *
                           (scan.velocity_in_map - last_scan->velocity_in_map) / pair.duration_s;
  motion_pairs.push_back(pair);
}

void LidarOdometry::Impl::name_imu_fault() {
  if (summary.imu_doubts.empty()) return;
  const auto fit = fit_mounting(motion_pairs);
  if (!fit) return;
  std::string text = "by the turns of the drive: " + mounting_text(*fit);
  const Eigen::AngleAxisd turn(fit->given_from_measured);
  constexpr double kWorthSaying_rad = 0.09;
  if (!fit->mirrored && turn.angle() > kWorthSaying_rad) {
    Eigen::Matrix4d mounting = rig.imu_from_lidar.matrix();
    mounting.topRows<3>() = fit->given_from_measured.transpose() * mounting.topRows<3>().eval();
    text += fmt::format("; write this mounting into sensors.yaml: imu_from_lidar: [{}]",
                        matrix_text(mounting));
  }
  summary.imu_doubts.push_back(text);
}

}  // namespace hybridfusion
