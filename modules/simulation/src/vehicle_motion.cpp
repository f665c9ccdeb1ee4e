#include "vehicle_motion.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {

VehicleMotion::VehicleMotion(Channels controls, double step_s)
    : controls_(std::move(controls)), step_s_(step_s) {
  HF_CHECK(controls_.front().size() >= 4 && step_s > 0.0);
}

double VehicleMotion::duration_s() const {
  return static_cast<double>(controls_.front().size() - 3) * step_s_;
}

MotionState VehicleMotion::at(double time_s) const {
  const double slot = std::clamp(time_s, 0.0, duration_s()) / step_s_;
  const auto i = std::min(static_cast<std::size_t>(slot), controls_.front().size() - 4);
  const double t = slot - static_cast<double>(i);
  const double s = 1.0 - t;
  const Eigen::Vector4d b0(s * s * s / 6.0,
                           (3 * t * t * t - 6 * t * t + 4) / 6.0,
                           (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6.0,
                           t * t * t / 6.0);
  const Eigen::Vector4d b1 =
      Eigen::Vector4d(
          -s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * t * t + 2 * t + 1) / 2, t * t / 2) /
      step_s_;
  const Eigen::Vector4d b2 = Eigen::Vector4d(s, 3 * t - 2, -3 * t + 1, t) / (step_s_ * step_s_);
  std::array<double, 6> value{};
  std::array<double, 6> rate{};
  MotionState state;
  for (std::size_t channel = 0; channel < 6; ++channel) {
    const Eigen::Map<const Eigen::Vector4d> c(controls_[channel].data() + i);
    value[channel] = b0.dot(c);
    rate[channel] = b1.dot(c);
    if (channel < 3) {
      state.velocity_mps[static_cast<Eigen::Index>(channel)] = rate[channel];
      state.acceleration_mps2[static_cast<Eigen::Index>(channel)] = b2.dot(c);
    }
  }
  const auto [x, y, z, yaw, pitch, roll] = value;
  state.world_from_body = {.rotation = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                       Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()),
                           .translation = {x, y, z}};
  // Body rates of the yaw-pitch-roll sequence (Diebel 2006, Eq. 72).
  const double yaw_rate = rate[3];
  const double pitch_rate = rate[4];
  const double roll_rate = rate[5];
  state.angular_velocity_radps = {
      roll_rate - yaw_rate * std::sin(pitch),
      pitch_rate * std::cos(roll) + yaw_rate * std::cos(pitch) * std::sin(roll),
      -pitch_rate * std::sin(roll) + yaw_rate * std::cos(pitch) * std::cos(roll)};
  return state;
}

}  // namespace hybridfusion
