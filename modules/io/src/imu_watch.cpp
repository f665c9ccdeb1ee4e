#include "imu_watch.hpp"

#include <algorithm>

namespace hybridfusion {
namespace {

constexpr double kGravity_mps2 = 9.80665;
// Between two accelerations of a slow unit (RealSense D435i: 63 Hz beside 200 Hz of its gyro).
constexpr std::chrono::milliseconds kRecent{50};
constexpr std::size_t kMinNorms = 20;
constexpr std::size_t kMaxNorms = 4096;

}  // namespace

std::optional<ImuSample> ImuWatch::complete(const DecodedImu& imu) {
  if (imu.has_force) {
    if (num_forces_++ % stride_ == 0) {
      norms_.push_back(static_cast<float>(imu.sample.specific_force_mps2.norm()));
    }
    if (norms_.size() == kMaxNorms) {  // every other one from here on
      for (std::size_t i = 0; i < kMaxNorms / 2; ++i) norms_[i] = norms_[2 * i];
      norms_.resize(kMaxNorms / 2);
      stride_ *= 2;
    }
  }
  if (imu.has_rate && imu.has_force) return imu.sample;
  if (imu.has_force) {
    ++counts_.without_rate;
    last_force_ = imu.sample;
    return std::nullopt;
  }
  if (imu.has_rate && last_force_ &&
      std::chrono::abs(imu.sample.time - last_force_->time) <= kRecent) {
    ImuSample sample = imu.sample;
    sample.specific_force_mps2 = last_force_->specific_force_mps2;
    return sample;
  }
  ++counts_.without_force;
  return std::nullopt;
}

ImuDialect ImuWatch::dialect() const {
  ImuDialect dialect = counts_;
  if (norms_.size() < kMinNorms) return dialect;
  std::vector<float> sorted = norms_;
  std::ranges::sort(sorted);
  dialect.force_median = sorted[sorted.size() / 2];
  dialect.force_low = sorted[sorted.size() / 20];
  // In g the norm stays near 1. Without gravity it is what moves the vehicle, and 0 when nothing
  // does; no vehicle accelerates by half of gravity most of the time.
  dialect.in_g =
      dialect.force_median > 0.8 && dialect.force_median < 1.2 && dialect.force_low > 0.6;
  dialect.gravity_removed = !dialect.in_g && dialect.force_median < 0.5 * kGravity_mps2;
  return dialect;
}

}  // namespace hybridfusion
