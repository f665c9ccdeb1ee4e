#include "recording_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace hybridfusion {
namespace {

constexpr std::uint64_t kScanStep = 20;  // ranges are measured in one scan of so many

bool has_return(const LidarPoint& point) {
  constexpr float kMinRange_m = 1e-3F;
  return point.point_in_lidar.allFinite() && point.point_in_lidar.norm() > kMinRange_m;
}

}  // namespace

double quantile_of(std::vector<double> values, double quantile) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 0.0;
  const double last = static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::lround(quantile * last));
  std::ranges::nth_element(values, nth);
  return *nth;
}

void StampStatistics::add(Timestamp stamp) {
  if (count_++ == 0) {
    first_ = last_ = stamp;
    return;
  }
  if (stamp < last_) {
    ++backwards_;
    return;
  }
  steps_s_.push_back(static_cast<float>(to_seconds(stamp - last_)));
  last_ = stamp;
}

double StampStatistics::period_s() const {
  return quantile_of({steps_s_.begin(), steps_s_.end()}, 0.5);
}

StampStatistics::Gaps StampStatistics::gaps(double limit_s) const {
  Gaps gaps;
  for (const float step_s : steps_s_) {
    if (!(step_s > limit_s)) continue;
    ++gaps.count;
    gaps.longest_s = std::max(gaps.longest_s, static_cast<double>(step_s));
  }
  return gaps;
}

void RecordingStatistics::add(const SensorMessage& message) {
  if (const auto* sample = std::get_if<ImuSample>(&message)) {
    imu.add(sample->time);
    force_mps2.push_back(sample->specific_force_mps2.norm());
    rotation_radps.push_back(sample->angular_velocity_radps.norm());
    return;
  }
  if (const auto* fix = std::get_if<GnssFix>(&message)) {
    const GeodeticPosition& position = fix->position;
    const bool usable = std::isfinite(position.altitude_m) &&
                        std::abs(position.latitude_deg) <= 90.0 &&
                        std::abs(position.longitude_deg) <= 180.0 &&
                        !(position.latitude_deg == 0.0 && position.longitude_deg == 0.0);
    if (usable) fixes.push_back(position);
    return;
  }
  const auto& scan = std::get<LidarScan>(message);
  std::vector<double> ranges;
  const bool measured = lidar.count() % kScanStep == 0;
  std::size_t count = 0;
  for (const LidarPoint& point : scan.points) {
    if (!has_return(point)) continue;
    ++count;
    if (measured) ranges.push_back(point.point_in_lidar.norm());
  }
  lidar.add(scan.stamp);
  returns.push_back(static_cast<double>(count));
  if (!ranges.empty()) ranges_m.push_back(quantile_of(std::move(ranges), 0.5));
}

}  // namespace hybridfusion
