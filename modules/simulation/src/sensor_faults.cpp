#include "sensor_faults.hpp"

#include "imu_model.hpp"

namespace hybridfusion {
namespace {

/// Rows: the axes of the sensor as turned, in those of the sound one.
Eigen::Matrix3d turn_of(const std::string& name) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (name == "x90") turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  if (name == "y90") turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  if (name == "z90") turn << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  if (name == "upside-down") turn << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  if (name == "swap-xy") turn << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

void turn_by(const Eigen::Matrix3d& turn, ImuSample& sample) {
  sample.angular_velocity_radps = turn * sample.angular_velocity_radps;
  sample.specific_force_mps2 = turn * sample.specific_force_mps2;
}

}  // namespace

ImuSample with_faults(ImuSample sample, const MotionState& state, const FaultOptions& faults) {
  if (faults.gravity_removed) {
    sample.specific_force_mps2 -=
        state.world_from_body.rotation.conjugate() * Eigen::Vector3d(0.0, 0.0, kGravity_mps2);
  }
  turn_by(turn_of(faults.imu_turn), sample);
  sample.angular_velocity_radps *= faults.gyro_scale;
  sample.specific_force_mps2 *= faults.accel_scale;
  sample.time += from_seconds(faults.imu_delay_s);
  return sample;
}

ImuSample turned_about_z(ImuSample sample) {
  turn_by(turn_of("z90"), sample);
  return sample;
}

}  // namespace hybridfusion
