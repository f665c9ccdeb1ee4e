#include <hybridfusion/lidar/lidar_rig.hpp>
#include <hybridfusion/lidar/odometry.hpp>
#include <hybridfusion/lidar/odometry_options.hpp>

#include <array>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {

Expected<void> validate(const LidarRig& rig) {
  const ImuNoise& noise = rig.imu_noise;
  const std::array<std::pair<const char*, double>, 4> densities{
      {{"gyro_noise_density", noise.gyro_noise_density},
       {"accel_noise_density", noise.accel_noise_density},
       {"gyro_bias_walk", noise.gyro_bias_walk},
       {"accel_bias_walk", noise.accel_bias_walk}}};
  for (const auto& [name, value] : densities) {
    if (!(value > 0.0 && value < 10.0)) {
      return fail(
          ErrorCode::kInvalidOptions,
          fmt::format(
              "{} = {} is outside (0, 10); take it from the IMU's data sheet", name, value));
    }
  }
  if (!rig.imu_from_lidar.translation.allFinite() ||
      !rig.imu_from_lidar.rotation.coeffs().allFinite() || !rig.gnss_antenna_in_imu.allFinite()) {
    return fail(ErrorCode::kInvalidOptions,
                "imu_from_lidar and gnss_antenna_in_imu must be finite numbers");
  }
  return {};
}

Expected<void> validate_odometry(const OdometryOptions& options) {
  if (auto valid = validate(options, "lidar.odometry"); !valid) return valid;
  if (options.min_range_m >= options.max_range_m) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("lidar.odometry.min_range_m = {} must be below lidar.odometry.max_range_m = {}",
                    options.min_range_m,
                    options.max_range_m));
  }
  if (options.local_map.cube_side_m < 3.0 * options.max_range_m) {
    return fail(
        ErrorCode::kInvalidOptions,
        fmt::format("lidar.odometry.local_map.cube_side_m = {} must be at least three times "
                    "lidar.odometry.max_range_m = {}, or the map loses points that are in sight",
                    options.local_map.cube_side_m,
                    options.max_range_m));
  }
  return {};
}

std::string flags_text(std::uint32_t flags) {
  constexpr std::array<std::pair<ScanFlag, const char*>, 11> kNames{
      {{ScanFlag::kImuGap, "imu_gap"},
       {ScanFlag::kLidarGap, "lidar_gap"},
       {ScanFlag::kFewPoints, "few_points"},
       {ScanFlag::kUnmatched, "unmatched"},
       {ScanFlag::kDegenerate, "degenerate"},
       {ScanFlag::kDiverged, "diverged"},
       {ScanFlag::kSaturated, "saturated"},
       {ScanFlag::kClockStep, "clock_step"},
       {ScanFlag::kNoPointTimes, "no_point_times"},
       {ScanFlag::kBadPoints, "bad_points"},
       {ScanFlag::kLoopCorrected, "loop_corrected"}}};
  std::string text;
  for (const auto& [flag, name] : kNames) {
    if ((flags & static_cast<std::uint32_t>(flag)) == 0) continue;
    if (!text.empty()) text += '|';
    text += name;
  }
  return text;
}

}  // namespace hybridfusion
