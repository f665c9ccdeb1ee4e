#pragma once

#include "imu_propagation.hpp"

#include <hybridfusion/core/sensor_data.hpp>

#include <cmath>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// IMU samples in strictly ascending time, cleaned of what drivers and clocks do to them.
class ImuBuffer {
 public:
  enum class Verdict : std::uint8_t { kTaken, kDropped, kHeld, kClockStep };

  /// Drops samples that are not finite, repeat a time or go back; follows a clock that stepped back
  /// for good; holds one sample that jumps far ahead until the next confirms it.
  Verdict add(ImuSample sample);

  [[nodiscard]] bool empty() const { return samples_.empty(); }
  [[nodiscard]] Timestamp first_time() const { return samples_.front().time; }
  [[nodiscard]] Timestamp last_time() const { return samples_.back().time; }
  [[nodiscard]] const std::deque<ImuSample>& samples() const { return samples_; }
  /// Multiplies the specific force of all samples, those to come included (IMUs that speak in g).
  void set_force_scale(double scale);

  /// Mid-point inputs that lead from `begin` to `end`; samples are interpolated at both, held
  /// beyond the data, and intervals are cut so that none exceeds 20 ms.
  [[nodiscard]] std::vector<ImuStep> steps(Timestamp begin, Timestamp end) const;
  /// Forgets what is not needed for times from `time` on.
  void forget_before(Timestamp time);
  [[nodiscard]] std::size_t num_gaps() const { return num_gaps_; }
  /// What is added to stamps since the clock stepped back.
  [[nodiscard]] Timestamp shift() const { return shift_; }
  [[nodiscard]] double typical_interval_s() const { return typical_interval_s_; }
  /// Densities of what lies between samples that come slower than 50 a second and that a line
  /// between them misses, from how far samples lie off the line between their neighbours; 0 for
  /// faster IMUs, whose vibration is no noise of the motion.
  [[nodiscard]] double gyro_roughness() const { return std::sqrt(gyro_roughness2_); }
  [[nodiscard]] double accel_roughness() const { return std::sqrt(accel_roughness2_); }
  /// Longest interval that is not a gap: five typical ones, at least 30 ms.
  [[nodiscard]] double gap_s() const;

 private:
  [[nodiscard]] ImuSample at(Timestamp time) const;
  void take(const ImuSample& sample);
  void note_roughness();

  std::deque<ImuSample> samples_ = {};
  std::deque<bool> saturated_ = {};
  std::optional<ImuSample> held_ = {};
  Timestamp shift_{};
  double force_scale_ = 1.0;
  double typical_interval_s_ = 0.0;
  double gyro_roughness2_ = 0.0;   // rad^2/s
  double accel_roughness2_ = 0.0;  // m^2/s^3
  int num_late_ = 0;
  std::size_t num_gaps_ = 0;
};

}  // namespace hybridfusion
