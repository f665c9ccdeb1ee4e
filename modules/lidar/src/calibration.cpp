#include "initialization.hpp"
#include "rig_fit.hpp"

#include <hybridfusion/lidar/calibration.hpp>
#include <hybridfusion/lidar/odometry.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// So loose that a scan's pose comes from its points; what is left of the IMU is the first guess.
constexpr ImuNoise kLooseImu = {.gyro_noise_density = 0.05,
                                .accel_noise_density = 3.0,
                                .gyro_bias_walk = 1e-6,
                                .accel_bias_walk = 1e-6};
constexpr double kSettled_rad = 2e-4;
constexpr double kSettled_m = 5e-4;
constexpr double kSettled_s = 5e-5;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}
constexpr std::uint32_t kUnusable = bit(ScanFlag::kImuGap) | bit(ScanFlag::kFewPoints) |
                                    bit(ScanFlag::kUnmatched) | bit(ScanFlag::kDegenerate) |
                                    bit(ScanFlag::kDiverged) | bit(ScanFlag::kSaturated) |
                                    bit(ScanFlag::kNoPointTimes);

using Held = std::array<bool, rig::kNumCalibrated>;

double limit_of(const CalibrationOptions& options, int at) {
  if (at < rig::kTranslation) return options.max_rotation_sigma_rad;
  return at < rig::kOffset ? options.max_translation_sigma_m : options.max_offset_sigma_s;
}

/// A fit of what the drive shows; the rest stays as given.
struct HonestFit {
  RigFit fit = {};
  std::array<CalibratedValue, rig::kNumCalibrated> values = {};
};

Expected<HonestFit> fit_honestly(const CalibrationOptions& options,
                                 std::span<const LidarPose> poses,
                                 const ImuBuffer& imu,
                                 const RigState& given,
                                 const RigState& start) {
  HonestFit out;
  HF_TRY(const RigFit free, fit_rig(poses, imu, given, start, {}));
  Held held = {};
  for (int i = 0; i < rig::kNumCalibrated; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double sigma = std::sqrt(free.covariance(i, i));
    out.values[at] = {.sigma = sigma, .found = sigma <= limit_of(options, i)};
    held[at] = !out.values[at].found;
  }
  HF_TRY(out.fit, fit_rig(poses, imu, given, given, held));
  for (int i = 0; i < rig::kNumCalibrated; ++i) {
    CalibratedValue& value = out.values[static_cast<std::size_t>(i)];
    if (value.found) value.sigma = std::sqrt(out.fit.covariance(i, i));
  }
  return out;
}

}  // namespace

struct RigCalibrator::Impl {
  CalibrationOptions options;
  OdometryOptions odometry;
  LidarRig rig;
  std::vector<SensorMessage> messages = {};
  bool imu_in_g = false;

  [[nodiscard]] Expected<std::vector<LidarPose>> locate(const RigState& state,
                                                        const RunContext& ctx);
  [[nodiscard]] ImuBuffer imu() const;
};

Expected<std::vector<LidarPose>> RigCalibrator::Impl::locate(const RigState& state,
                                                             const RunContext& ctx) {
  OdometryOptions with_offset = odometry;
  with_offset.imu_time_offset_s = state.imu_time_offset_s;
  with_offset.filter.estimate_extrinsic = false;
  LidarRig loose = rig;
  loose.imu_from_lidar = state.imu_from_lidar;
  loose.imu_noise = kLooseImu;
  HF_TRY(LidarOdometry filter, LidarOdometry::create(with_offset, loose));
  std::vector<LidarPose> poses;
  const auto collect = [&] {
    for (const ScanEstimate& scan : filter.take()) {
      poses.push_back({.time = scan.time,
                       .map_from_lidar = scan.map_from_imu * scan.imu_from_lidar,
                       .usable = (scan.quality.flags & kUnusable) == 0});
    }
  };
  for (const SensorMessage& message : messages) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped during the calibration");
    if (const auto* sample = std::get_if<ImuSample>(&message)) filter.add_imu(*sample);
    if (const auto* scan = std::get_if<LidarScan>(&message)) filter.add_scan(*scan);
    collect();
  }
  if (auto finished = filter.finish(); !finished) return std::unexpected(finished.error());
  collect();
  imu_in_g = filter.summary().imu_in_g;
  return poses;
}

ImuBuffer RigCalibrator::Impl::imu() const {
  ImuBuffer buffer;
  for (const SensorMessage& message : messages) {
    if (const auto* sample = std::get_if<ImuSample>(&message)) (void)buffer.add(*sample);
  }
  if (imu_in_g) buffer.set_force_scale(kStandardGravity_mps2);
  return buffer;
}

RigCalibrator::RigCalibrator(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RigCalibrator::RigCalibrator(RigCalibrator&&) noexcept = default;
RigCalibrator& RigCalibrator::operator=(RigCalibrator&&) noexcept = default;
RigCalibrator::~RigCalibrator() = default;

Expected<RigCalibrator> RigCalibrator::create(const CalibrationOptions& options,
                                              const OdometryOptions& odometry,
                                              const LidarRig& rig) {
  if (auto valid = validate(options, "lidar.calibration"); !valid) {
    return std::unexpected(valid.error());
  }
  if (auto valid = validate_odometry(odometry); !valid) return std::unexpected(valid.error());
  if (auto valid = validate(rig); !valid) return std::unexpected(valid.error());
  return RigCalibrator(
      std::make_unique<Impl>(Impl{.options = options, .odometry = odometry, .rig = rig}));
}

void RigCalibrator::add(SensorMessage message) {
  if (std::holds_alternative<GnssFix>(message)) return;
  if (auto* scan = std::get_if<LidarScan>(&message)) {
    const std::size_t stride =
        scan->points.size() / static_cast<std::size_t>(impl_->options.max_points_per_scan) + 1;
    std::vector<LidarPoint> kept;
    kept.reserve(scan->points.size() / stride + 1);
    for (std::size_t i = 0; i < scan->points.size(); i += stride) kept.push_back(scan->points[i]);
    scan->points = std::move(kept);
  }
  impl_->messages.push_back(std::move(message));
}

Expected<RigCalibration> RigCalibrator::finish(const RunContext& ctx) {
  const CalibrationOptions& options = impl_->options;
  const RigState given{.imu_from_lidar = impl_->rig.imu_from_lidar,
                       .imu_time_offset_s = impl_->odometry.imu_time_offset_s};
  RigState state = given;
  HonestFit last;
  RigCalibration out;
  for (int pass = 0; pass < options.passes; ++pass) {
    ctx.report({.stage = "calibrate", .done = pass, .total = options.passes});
    HF_TRY(const std::vector<LidarPose> poses, impl_->locate(state, ctx));
    HF_TRY(last, fit_honestly(options, poses, impl_->imu(), given, state));
    const RigState& next = last.fit.state;
    out.num_scans = static_cast<std::size_t>(
        std::ranges::count_if(poses, [](const LidarPose& pose) { return pose.usable; }));
    out.passes = pass + 1;
    const bool settled =
        rotation_distance_rad(next.imu_from_lidar.rotation, state.imu_from_lidar.rotation) <
            kSettled_rad &&
        (next.imu_from_lidar.translation - state.imu_from_lidar.translation).norm() < kSettled_m &&
        std::abs(next.imu_time_offset_s - state.imu_time_offset_s) < kSettled_s;
    state = next;
    if (settled) break;
  }
  if (std::ranges::none_of(last.values, &CalibratedValue::found)) {
    return fail(
        ErrorCode::kDegenerate,
        fmt::format("the motion shows nothing of the LiDAR's mounting or clock (heading of the "
                    "LiDAR known to {:.2f} rad, time offset to {:.1f} ms); drive curves both ways "
                    "with clear changes of speed, best a figure-eight, and over a ramp or bumps",
                    last.values[2].sigma,
                    1e3 * last.values[rig::kOffset].sigma));
  }
  out.imu_from_lidar = state.imu_from_lidar;
  out.imu_time_offset_s = state.imu_time_offset_s;
  std::copy_n(last.values.begin(), 3, out.rotation.begin());
  std::copy_n(last.values.begin() + rig::kTranslation, 3, out.translation.begin());
  out.time_offset = last.values[rig::kOffset];
  out.rms_rotation_rad = last.fit.rms_rotation_rad;
  out.rms_velocity_mps = last.fit.rms_velocity_mps;
  return out;
}

}  // namespace hybridfusion
