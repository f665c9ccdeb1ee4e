#include "odometry_impl.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Scans that find_start_motion looks at.
constexpr std::size_t kLookedAt = 6;
// With fewer the recording is over before the IMU could be compared with anything.
constexpr std::size_t kMinScansForImu = 5;
// What find_start_motion may be off.
constexpr double kStartSpeedSigma_mps = 1.0;
constexpr double kStartTurnSigma_radps = 0.1;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}

/// Mean residual over what both filters matched: the lower, the better the motion explains the
/// scans.
double misfit_m(std::span<const ScanEstimate> scans) {
  double sum_m = 0.0;
  int count = 0;
  for (const ScanEstimate& scan : scans) {
    if (scan.quality.num_matched == 0) continue;
    sum_m += scan.quality.mean_residual_m;
    ++count;
  }
  return count == 0 ? 0.0 : sum_m / count;
}

}  // namespace

bool LidarOdometry::Impl::wants_imu() const {
  if (rig.imu_use == ImuUse::kNone) return false;
  // An IMU that is not believed is still listened to: what it says may tell what is wrong with it.
  return !filter || !imu.empty();
}

StartMotion LidarOdometry::Impl::motion_of_first_scans() {
  if (start_motion) return *start_motion;
  std::vector<PreparedScan> scans;
  for (const PreparedScan& scan : waiting) {
    if (scans.size() == kLookedAt) break;
    if ((scan.flags & bit(ScanFlag::kFewPoints)) == 0) scans.push_back(scan);
  }
  Eigen::Vector3d up = rig.imu_from_lidar.rotation * Eigen::Vector3d::UnitZ();
  Eigen::Vector3d turn_rate = Eigen::Vector3d::Zero();
  if (!imu.empty() && !scans.empty()) {
    const ImuMean mean = imu_mean(imu, scans.front().begin, scans.back().end);
    if (mean.specific_force_mps2.norm() > 1.0) up = mean.specific_force_mps2;
    if (mean.num_samples > 0) turn_rate = mean.angular_velocity_radps;
  }
  ++num_start_attempts;
  start_motion = find_start_motion(options, rig, scans, up, turn_rate);
  return *start_motion;
}

bool LidarOdometry::Impl::lidar_stands_still() {
  // A steady drive looks still to the IMU but not to the LiDAR.
  // Few points leave some tenths open; who creeps shakes.
  constexpr double kMaxSpeed_mps = 0.6;
  const StartMotion motion = motion_of_first_scans();
  return motion.problem == StartProblem::kFewScans || motion.velocity_mps.norm() < kMaxSpeed_mps;
}

std::vector<ScanEstimate> LidarOdometry::Impl::follow_without_imu(const StartMotion& motion,
                                                                  Timestamp until) const {
  ScanFilter trial(options,
                   rig,
                   coasting_state(rig, motion, kStartSpeedSigma_mps, kStartTurnSigma_radps),
                   waiting.front().begin,
                   MotionModel::kConstantVelocity);
  std::vector<ScanEstimate> poses;
  for (const PreparedScan& scan : waiting) {
    if (scan.end > until) break;
    poses.push_back(trial.process(scan, imu));
    poses.back().deskewed = {};
  }
  return poses;
}

/// Each time twice as many scans are left out: the cost of all attempts stays in proportion.
void LidarOdometry::Impl::postpone_start() {
  const std::size_t count =
      std::min(waiting.size(), std::size_t{2} << std::min(num_start_attempts, 10));
  waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count));
  summary.num_scans_before_start += count;
  start_motion.reset();
}

bool LidarOdometry::Impl::start_moving(bool last) {
  if (waiting.size() < kLookedAt && !last) return false;
  const StartMotion motion = motion_of_first_scans();
  if (motion.problem) {
    postpone_start();
    return false;
  }
  const Timestamp begin = waiting.front().begin;
  filter.emplace(options,
                 rig,
                 coasting_state(rig, motion, kStartSpeedSigma_mps, kStartTurnSigma_radps),
                 begin,
                 MotionModel::kConstantVelocity);
  if (rig.imu_use == ImuUse::kNone || imu.empty()) return true;
  summary.warnings.emplace_back(
      "no standstill at the start: level and velocity come from the first seconds of motion; "
      "stand still for 2 s before driving off for the best start");
  const Timestamp until = std::min(imu.last_time(), begin + from_seconds(options.init.max_wait_s));
  const std::vector<ScanEstimate> by_lidar = follow_without_imu(motion, until);
  if (by_lidar.size() < kMinScansForImu) {
    StateEstimate guess = moving_state(imu_mean(imu, imu.first_time(), imu.last_time()), rig);
    guess.state.velocity_in_map = guess.state.map_from_imu * motion.velocity_mps;
    filter.emplace(options, rig, guess, begin, MotionModel::kInertial);
    return true;
  }
  const auto start = fit_moving_state(by_lidar, begin, imu, rig);
  if (!start) {
    summary.imu_doubts.emplace_back("it does not measure gravity while the LiDAR moves");
    return true;
  }
  ScanFilter trial(options, rig, *start, begin, MotionModel::kInertial);
  std::vector<ScanEstimate> by_imu;
  for (std::size_t i = 0; i < by_lidar.size(); ++i) {
    by_imu.push_back(trial.process(waiting[i], imu));
    by_imu.back().deskewed = {};
  }
  // The IMU must not make the scans fit worse than they do without it.
  constexpr double kWorse = 1.25;
  if (misfit_m(by_imu) > kWorse * misfit_m(by_lidar)) {
    summary.imu_doubts.push_back(
        fmt::format("with it the first scans fit each other to {:.3f} m, without it to {:.3f} m",
                    misfit_m(by_imu),
                    misfit_m(by_lidar)));
    return true;
  }
  filter.emplace(options, rig, *start, begin, MotionModel::kInertial);
  return true;
}

bool LidarOdometry::Impl::start_with_imu(bool last) {
  const Timestamp begin = waiting.front().begin;
  const Timestamp data_begin = std::max(begin, imu.first_time());
  const Timestamp still_end = data_begin + from_seconds(options.init.standstill_s);
  if (!last && imu.last_time() < still_end) return false;
  ImuMean mean = imu_mean(imu, imu.first_time(), still_end);
  if (mean.num_samples == 0) mean = imu_mean(imu, imu.first_time(), imu.last_time());
  if (!summary.imu_in_g && speaks_in_g(mean)) {
    imu.set_force_scale(kStandardGravity_mps2);
    summary.imu_in_g = true;
    summary.warnings.emplace_back("the accelerometer speaks in g, not m/s^2: scaled by 9.80665");
    mean = imu_mean(imu, imu.first_time(), still_end);
  }
  // Without gravity in it there is no level: the start in motion says so.
  const double force = mean.specific_force_mps2.norm() / kStandardGravity_mps2;
  const bool measures_gravity = force > 0.5 && force < 1.5;
  if (measures_gravity && is_standstill(mean, options.init, rig.imu_noise) &&
      lidar_stands_still()) {
    constexpr double kStillSpeed_mps = 0.02;
    summary.started_at_standstill = true;
    filter.emplace(
        options, rig, standstill_state(mean, rig, kStillSpeed_mps), begin, MotionModel::kInertial);
    return true;
  }
  if (!last && to_seconds(imu.last_time() - data_begin) < options.init.max_wait_s) return false;
  return start_moving(last);
}

bool LidarOdometry::Impl::try_start(bool last) {
  const bool with_imu = rig.imu_use != ImuUse::kNone && !imu.empty();
  return with_imu ? start_with_imu(last) : start_moving(last);
}

}  // namespace hybridfusion
