#pragma once

#include "imu_vibration.hpp"
#include "vehicle_motion.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <optional>

namespace hybridfusion {

inline constexpr double kGravity_mps2 = 9.80665;

/// IMU errors: white noise, constant start bias and a random walk of the bias, per axis; the
/// vibration of the vehicle where asked for.
class ImuModel {
 public:
  ImuModel(const ImuModelOptions& options, std::uint64_t seed, std::uint64_t index);

  /// The next sample, 1/rate after the one before. @param state  True motion of the IMU.
  [[nodiscard]] ImuSample measure(const MotionState& state, Timestamp time);

 private:
  [[nodiscard]] Eigen::Vector3d normal3();

  Random random_;
  std::optional<CarVibration> vibration_ = {};
  double rate_hz_;
  std::uint64_t samples_ = 0;
  double gyro_white_;
  double accel_white_;
  double gyro_step_;
  double accel_step_;
  Eigen::Vector3d gyro_bias_;
  Eigen::Vector3d accel_bias_;
};

}  // namespace hybridfusion
