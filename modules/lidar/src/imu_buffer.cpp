#include "imu_buffer.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kMaxStep_s = 0.02;
constexpr double kSuspiciousJump_s = 1.0;
constexpr int kLateUntilStep = 20;
// A channel that repeats the very same large value does not measure any more.
constexpr double kSaturationRate_radps = 2.0;
constexpr double kSaturationForce_mps2 = 25.0;

bool repeats_large(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double large) {
  for (int i = 0; i < 3; ++i) {
    if (a[i] == b[i] && std::abs(a[i]) >= large) return true;
  }
  return false;
}

bool is_saturated(const ImuSample& a, const ImuSample& b) {
  return repeats_large(a.angular_velocity_radps, b.angular_velocity_radps, kSaturationRate_radps) ||
         repeats_large(a.specific_force_mps2, b.specific_force_mps2, kSaturationForce_mps2);
}

}  // namespace

ImuBuffer::Verdict ImuBuffer::add(ImuSample sample) {
  if (!sample.angular_velocity_radps.allFinite() || !sample.specific_force_mps2.allFinite()) {
    return Verdict::kDropped;
  }
  sample.time += shift_;
  sample.specific_force_mps2 *= force_scale_;
  if (samples_.empty()) {
    take(sample);
    return Verdict::kTaken;
  }
  if (held_ && sample.time > held_->time) {
    take(*held_);
    held_.reset();
  }
  if (sample.time <= last_time()) {
    // A repeated stamp now and then is a duplicate; a run of late ones is a clock that was set
    // back.
    if (++num_late_ < kLateUntilStep) return Verdict::kDropped;
    const Timestamp step =
        last_time() + from_seconds(num_late_ * typical_interval_s_) - sample.time;
    shift_ += step;
    sample.time += step;
    take(sample);
    return Verdict::kClockStep;
  }
  num_late_ = 0;
  if (to_seconds(sample.time - last_time()) > kSuspiciousJump_s && !held_) {
    held_ = sample;
    return Verdict::kHeld;
  }
  held_.reset();
  take(sample);
  return Verdict::kTaken;
}

void ImuBuffer::take(const ImuSample& sample) {
  num_late_ = 0;
  bool saturated = false;
  if (!samples_.empty()) {
    const double interval_s = to_seconds(sample.time - last_time());
    if (typical_interval_s_ > 0.0 && interval_s > gap_s()) {
      ++num_gaps_;
    } else {
      typical_interval_s_ = typical_interval_s_ == 0.0
                                ? std::min(interval_s, 0.1)
                                : 0.98 * typical_interval_s_ + 0.02 * interval_s;
    }
    saturated = is_saturated(samples_.back(), sample);
    if (saturated) saturated_.back() = true;
  }
  samples_.push_back(sample);
  saturated_.push_back(saturated);
  note_roughness();
}

void ImuBuffer::note_roughness() {
  constexpr double kSlow_s = 0.02;
  constexpr double kMemory_s = 5.0;
  if (typical_interval_s_ < kSlow_s || samples_.size() < 3) return;
  const ImuSample& a = samples_[samples_.size() - 3];
  const ImuSample& b = samples_[samples_.size() - 2];
  const ImuSample& c = samples_.back();
  const double whole_s = to_seconds(c.time - a.time);
  if (whole_s > 2.0 * gap_s()) return;
  const double share = to_seconds(b.time - a.time) / whole_s;
  // White noise of variance s^2 leaves 3/2 s^2 off the line, a mean over three axes.
  const auto density2 =
      [&](const Eigen::Vector3d& from, const Eigen::Vector3d& at, const Eigen::Vector3d& to) {
        return (at - from - share * (to - from)).squaredNorm() / 4.5 * 0.5 * whole_s;
      };
  const double gain = std::min(1.0, 0.5 * whole_s / kMemory_s);
  gyro_roughness2_ +=
      gain *
      (density2(a.angular_velocity_radps, b.angular_velocity_radps, c.angular_velocity_radps) -
       gyro_roughness2_);
  accel_roughness2_ +=
      gain * (density2(a.specific_force_mps2, b.specific_force_mps2, c.specific_force_mps2) -
              accel_roughness2_);
}

double ImuBuffer::gap_s() const {
  return std::max(0.03, 5.0 * typical_interval_s_);
}

void ImuBuffer::set_force_scale(double scale) {
  for (ImuSample& sample : samples_) sample.specific_force_mps2 *= scale / force_scale_;
  if (held_) held_->specific_force_mps2 *= scale / force_scale_;
  force_scale_ = scale;
}

ImuSample ImuBuffer::at(Timestamp time) const {
  const auto after =
      std::ranges::lower_bound(samples_, time, {}, [](const ImuSample& s) { return s.time; });
  if (after == samples_.begin()) return samples_.front();
  if (after == samples_.end()) return samples_.back();
  const ImuSample& b = *after;
  const ImuSample& a = *(after - 1);
  const double share = to_seconds(time - a.time) / to_seconds(b.time - a.time);
  return {.time = time,
          .angular_velocity_radps = a.angular_velocity_radps +
                                    share * (b.angular_velocity_radps - a.angular_velocity_radps),
          .specific_force_mps2 =
              a.specific_force_mps2 + share * (b.specific_force_mps2 - a.specific_force_mps2)};
}

std::vector<ImuStep> ImuBuffer::steps(Timestamp begin, Timestamp end) const {
  std::vector<ImuStep> out;
  if (samples_.empty()) return out;
  const double limit_s = gap_s();
  const auto time_of = [](const ImuSample& s) { return s.time; };
  auto next = static_cast<std::size_t>(std::ranges::upper_bound(samples_, begin, {}, time_of) -
                                       samples_.begin());
  Timestamp now = begin;
  while (now < end) {
    // The interval of samples that `now` lies in; open at either end of the data.
    const bool before = next == 0;
    const bool after = next == samples_.size();
    const Timestamp border = after ? end : std::min(end, samples_[next].time);
    const double hold_s = before
                              ? to_seconds(samples_.front().time - now)
                              : (after ? to_seconds(end - samples_.back().time)
                                       : to_seconds(samples_[next].time - samples_[next - 1].time));
    const bool saturated = (!before && saturated_[next - 1]) || (!after && saturated_[next]);
    const auto num_parts = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(to_seconds(border - now) / kMaxStep_s)));
    const Timestamp from = now;
    for (std::int64_t part = 1; part <= num_parts; ++part) {
      const Timestamp to = from + (border - from) * part / num_parts;
      const ImuSample a = at(now);
      const ImuSample b = at(to);
      out.push_back(
          {.dt_s = to_seconds(to - now),
           .angular_velocity_radps = 0.5 * (a.angular_velocity_radps + b.angular_velocity_radps),
           .specific_force_mps2 = 0.5 * (a.specific_force_mps2 + b.specific_force_mps2),
           .bridged = hold_s > limit_s,
           .held = hold_s > limit_s && (before || after),
           .saturated = saturated});
      now = to;
    }
    ++next;
  }
  std::erase_if(out, [](const ImuStep& step) { return step.dt_s <= 0.0; });
  return out;
}

void ImuBuffer::forget_before(Timestamp time) {
  while (samples_.size() > 2 && samples_[1].time < time) {
    samples_.pop_front();
    saturated_.pop_front();
  }
}

}  // namespace hybridfusion
