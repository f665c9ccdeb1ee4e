#include "imu_model.hpp"

#include <cmath>

namespace hybridfusion {

ImuModel::ImuModel(const ImuModelOptions& options, std::uint64_t seed, std::uint64_t index)
    : random_(seed, "imu/noise", index), rate_hz_(options.rate_hz) {
  if (options.vibration == "car") vibration_.emplace(seed, index);
  // Density to standard deviation of one sample: sigma = density * sqrt(rate); walk per step:
  // density * sqrt(1 / rate) (Crassidis 2006).
  const double root_rate = std::sqrt(options.rate_hz);
  gyro_white_ = options.gyro_noise_density * root_rate;
  accel_white_ = options.accel_noise_density * root_rate;
  gyro_step_ = options.gyro_bias_walk / root_rate;
  accel_step_ = options.accel_bias_walk / root_rate;
  gyro_bias_ = options.gyro_bias_sd_radps * normal3();
  accel_bias_ = options.accel_bias_sd_mps2 * normal3();
}

Eigen::Vector3d ImuModel::normal3() {
  const double x = random_.normal();
  const double y = random_.normal();
  return {x, y, random_.normal()};
}

ImuSample ImuModel::measure(const MotionState& state, Timestamp time) {
  const Eigen::Quaterniond imu_from_world = state.world_from_body.rotation.conjugate();
  const Eigen::Vector3d up(0.0, 0.0, kGravity_mps2);
  ImuSample sample{.time = time};
  sample.angular_velocity_radps =
      state.angular_velocity_radps + gyro_bias_ + gyro_white_ * normal3();
  sample.specific_force_mps2 =
      imu_from_world * (state.acceleration_mps2 + up) + accel_bias_ + accel_white_ * normal3();
  if (vibration_) {
    const Vibration felt =
        vibration_->at(static_cast<double>(samples_) / rate_hz_, state.velocity_mps.norm());
    sample.angular_velocity_radps += felt.gyro_radps;
    sample.specific_force_mps2 += felt.accel_mps2;
  }
  ++samples_;
  gyro_bias_ += gyro_step_ * normal3();
  accel_bias_ += accel_step_ * normal3();
  return sample;
}

}  // namespace hybridfusion
