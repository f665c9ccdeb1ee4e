#include "imu_watch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kWindow = 15;
// Squared, in variances; see "A drive judges itself" in docs/explanation/lidar.md for what good and
// bad drives reach.
constexpr double kMaxTurnInnovation = 400.0;
constexpr double kMaxShiftInnovation = 400.0;
// Ten times what consumer units have after warming up.
constexpr double kMaxGyroBias_radps = 0.2;
constexpr double kMaxAccelBias_mps2 = 2.0;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}
constexpr std::uint32_t kNotCounted = bit(ScanFlag::kImuGap) | bit(ScanFlag::kLidarGap) |
                                      bit(ScanFlag::kFewPoints) | bit(ScanFlag::kUnmatched) |
                                      bit(ScanFlag::kSaturated) | bit(ScanFlag::kClockStep);

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

std::optional<std::string> ImuWatch::add(const ScanEstimate& scan) {
  if (scan.gyro_bias_radps.norm() > kMaxGyroBias_radps) {
    return fmt::format("its gyro would have a bias of {:.2f} rad/s", scan.gyro_bias_radps.norm());
  }
  if (scan.accel_bias_mps2.norm() > kMaxAccelBias_mps2) {
    return fmt::format("its accelerometer would have a bias of {:.1f} m/s^2",
                       scan.accel_bias_mps2.norm());
  }
  if ((scan.quality.flags & kNotCounted) != 0) return std::nullopt;
  recent_.push_back({.turn = scan.quality.turn_innovation, .shift = scan.quality.shift_innovation});
  if (recent_.size() > kWindow) recent_.pop_front();
  if (recent_.size() < kWindow) return std::nullopt;
  std::vector<double> turns;
  std::vector<double> shifts;
  for (const Innovation& innovation : recent_) {
    turns.push_back(innovation.turn);
    shifts.push_back(innovation.shift);
  }
  const double turn = median(turns);
  const double shift = median(shifts);
  if (turn > kMaxTurnInnovation) {
    return fmt::format("the turns it predicts are {:.0f} times farther off than it states",
                       std::sqrt(turn));
  }
  if (shift > kMaxShiftInnovation) {
    return fmt::format("the motion it predicts is {:.0f} times farther off than it states",
                       std::sqrt(shift));
  }
  return std::nullopt;
}

}  // namespace hybridfusion
