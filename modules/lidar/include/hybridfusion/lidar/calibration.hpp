#pragma once

#include <hybridfusion/core/options.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/lidar/lidar_rig.hpp>
#include <hybridfusion/lidar/odometry_options.hpp>

#include <array>
#include <memory>

namespace hybridfusion {

struct CalibrationOptions {
  int passes = 4;
  int max_points_per_scan = 6000;
  double max_rotation_sigma_rad = 0.005;
  double max_translation_sigma_m = 0.02;
  double max_offset_sigma_s = 0.002;
};
template <>
struct OptionFields<CalibrationOptions> {
  using T = CalibrationOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::passes,
            {.key = "passes",
             .unit = "1",
             .min = 1,
             .max = 20,
             .doc = "LiDAR poses and fit, each with the calibration of the pass before.",
             .source = "ours"}},
      Field{&T::max_points_per_scan,
            {.key = "max_points_per_scan",
             .unit = "1",
             .min = 500,
             .max = 1e6,
             .doc = "Denser scans keep every n-th point (24 bytes each, held for all passes).",
             .source = "ours"}},
      Field{&T::max_rotation_sigma_rad,
            {.key = "max_rotation_sigma_rad",
             .unit = "rad",
             .min = 1e-5,
             .max = 1.0,
             .doc = "A rotation about an IMU axis less certain than this keeps its given value.",
             .source = "ours"}},
      Field{&T::max_translation_sigma_m,
            {.key = "max_translation_sigma_m",
             .unit = "m",
             .min = 1e-4,
             .max = 10.0,
             .doc = "A lever arm along an IMU axis less certain than this keeps its given value.",
             .source = "ours"}},
      Field{&T::max_offset_sigma_s,
            {.key = "max_offset_sigma_s",
             .unit = "s",
             .min = 1e-5,
             .max = 1.0,
             .doc = "A time offset less certain than this keeps its given value.",
             .source = "ours"}},
  };
};

/// One number that the drive may or may not show.
struct CalibratedValue {
  double sigma = 0.0;  ///< Formal deviation, from the residuals of the fit.
  bool found = false;  ///< False: not excited by the motion; the given value was kept.
};

struct RigCalibration {
  Rigid3 imu_from_lidar = {};
  /// Added to the IMU stamps it brings them onto the LiDAR clock.
  double imu_time_offset_s = 0.0;
  std::array<CalibratedValue, 3> rotation = {};     ///< About the IMU's x, y, z [rad].
  std::array<CalibratedValue, 3> translation = {};  ///< Along the IMU's x, y, z [m].
  CalibratedValue time_offset = {};                 ///< [s]
  int passes = 0;
  std::size_t num_scans = 0;      ///< Located ones that took part.
  double rms_rotation_rad = 0.0;  ///< Of LiDAR against gyro over 0.3 s.
  double rms_velocity_mps = 0.0;  ///< Of LiDAR against accelerometer over 1 s.
};

/// LiDAR-IMU extrinsic and time offset from a drive, given both roughly: LiDAR poses that owe the
/// IMU nothing but the first guess, against the IMU between them (hand-eye rotation, lever arm and
/// specific force, one least-squares fit), repeated with the scans undistorted anew.
/// Memory: 24 bytes a kept point.
class RigCalibrator {
 public:
  /// @param rig  What is known so far: within about 10 degrees, 0.3 m and 0.1 s.
  /// @returns kInvalidOptions.
  [[nodiscard]] static Expected<RigCalibrator> create(const CalibrationOptions& options,
                                                      const OdometryOptions& odometry,
                                                      const LidarRig& rig);
  RigCalibrator(RigCalibrator&&) noexcept;
  RigCalibrator& operator=(RigCalibrator&&) noexcept;
  ~RigCalibrator();

  /// Messages in the order of recording.
  void add(SensorMessage message);
  /// @returns kInsufficient for too little data; kDegenerate when the motion shows none of the
  /// numbers (the message says what to drive); kCancelled.
  [[nodiscard]] Expected<RigCalibration> finish(const RunContext& ctx);

 private:
  struct Impl;
  explicit RigCalibrator(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hybridfusion
