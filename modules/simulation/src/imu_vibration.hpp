#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// What the IMU of a car feels beside the motion of the car.
struct Vibration {
  Eigen::Vector3d accel_mps2 = Eigen::Vector3d::Zero();
  Eigen::Vector3d gyro_radps = Eigen::Vector3d::Zero();
};

/// Vibration of a car as a sum of tones: the same function of time at any sample rate, so that a
/// slow IMU folds it down as a real one without a filter does.
class CarVibration {
 public:
  CarVibration(std::uint64_t seed, std::uint64_t index);

  /// @param speed_mps  Of the vehicle.
  [[nodiscard]] Vibration at(double time_s, double speed_mps) const;

 private:
  struct Tone {
    double frequency_hz = 0.0;
    // Of the acceleration x y z [m/s^2] and the rate x y z [rad/s].
    Eigen::Matrix<double, 6, 1> amplitude = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 1> phase_rad = Eigen::Matrix<double, 6, 1>::Zero();
  };
  [[nodiscard]] static Vibration sum(const std::vector<Tone>& tones, double time_s);

  std::vector<Tone> road_ = {};
  std::vector<Tone> engine_ = {};
};

}  // namespace hybridfusion
