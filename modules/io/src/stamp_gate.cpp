#include "stamp_gate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t kStartMessages = 5;
constexpr std::size_t kRunMessages = 5;
constexpr std::size_t kRecent = 101;
constexpr std::size_t kMaxParkedScans = 8;
constexpr std::size_t kMaxParked = 256;
// Times of recording of one sensor scatter by less around its stamps.
constexpr Timestamp kSameClock = milliseconds(200);
constexpr Timestamp kPauseTolerance = milliseconds(300);

[[nodiscard]] Timestamp median(std::vector<Timestamp> values) {
  if (values.empty()) return {};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

void push_recent(std::deque<Timestamp>& values, Timestamp value) {
  values.push_back(value);
  if (values.size() > kRecent) values.pop_front();
}

}  // namespace

Timestamp& stamp_of(SensorMessage& message) {
  if (auto* const scan = std::get_if<LidarScan>(&message)) return scan->stamp;
  if (auto* const fix = std::get_if<GnssFix>(&message)) return fix->time;
  return std::get<ImuSample>(message).time;
}

void add_stamp_warnings(RecordingSummary& summary) {
  const auto tell = [&summary](std::string_view sensor, const StampFaults& faults) {
    std::string text;
    const auto part = [&text](std::uint64_t count, std::string_view what) {
      if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    };
    part(faults.missing, "without a stamp (the time of recording stands in)");
    part(faults.repeated, "with the stamp of the one before (left out)");
    part(faults.late, "older than the one before (left out)");
    part(faults.ahead, "far ahead of their time (put where they belong)");
    part(faults.dropped, "out of order for good (left out)");
    if (!text.empty()) summary.warnings.push_back(fmt::format("{} messages: {}", sensor, text));
  };
  tell("IMU", summary.imu_stamps);
  tell("LiDAR", summary.lidar_stamps);
  tell("GNSS", summary.gnss_stamps);
}

Timestamp StampGate::max_gap() const {
  const Timestamp period = median({gaps_.begin(), gaps_.end()});
  return std::max<Timestamp>(seconds(1), 10 * period);
}

Timestamp StampGate::offset() const {
  return median({offsets_.begin(), offsets_.end()});
}

void StampGate::warn(std::string text) {
  constexpr std::size_t kMaxWarnings = 20;
  if (warnings_.size() < kMaxWarnings) warnings_.push_back(std::move(text));
}

std::vector<std::string> StampGate::take_warnings() {
  return std::exchange(warnings_, {});
}

std::optional<SensorMessage> StampGate::take() {
  if (ready_.empty()) return std::nullopt;
  SensorMessage message = std::move(ready_.front());
  ready_.pop_front();
  return message;
}

void StampGate::add(SensorMessage message, Timestamp recorded) {
  Held held = {.stamp = stamp_of(message), .recorded = recorded};
  held.message = std::move(message);
  if (!started_) {
    first_.push_back(std::move(held));
    if (first_.size() == kStartMessages) start();
    return;
  }
  judge(std::move(held));
}

/// The earliest of the first messages that most of the others follow is the start.
void StampGate::start() {
  started_ = true;
  std::vector<Held> first = std::exchange(first_, {});
  std::vector<Timestamp> offsets;
  std::vector<Timestamp> gaps;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].stamp == Timestamp{}) continue;
    offsets.push_back(first[i].stamp - first[i].recorded);
    if (i > 0 && first[i - 1].stamp != Timestamp{} && first[i].stamp > first[i - 1].stamp) {
      gaps.push_back(first[i].stamp - first[i - 1].stamp);
    }
  }
  offsets_.push_back(median(offsets));
  if (!gaps.empty()) gaps_.push_back(median(gaps));
  std::size_t best = 0;
  std::size_t best_followers = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::size_t followers = 0;
    Timestamp end = first[i].stamp;
    for (std::size_t k = i + 1; k < first.size() && end != Timestamp{}; ++k) {
      if (first[k].stamp <= end || first[k].stamp > end + max_gap()) continue;
      end = first[k].stamp;
      ++followers;
    }
    if (followers <= best_followers) continue;
    best = i;
    best_followers = followers;
  }
  const bool timed = !first.empty() && first[best].stamp != Timestamp{};
  if (timed) last_ = first[best].stamp - Timestamp(1);
  for (Held& held : first) judge(std::move(held));
}

void StampGate::judge(Held held) {
  if (held.stamp == Timestamp{} || clock_stands_) {
    if (!clock_stands_) ++faults_.missing;
    held.stamp = held.recorded + offset();
  } else {
    held.stamp += shift_;
  }
  if (!last_ || (held.stamp > *last_ && held.stamp <= *last_ + max_gap() && !shows_step(held))) {
    pass(std::move(held));
  } else {
    hold(std::move(held));
  }
}

/// A step of the clock too small to leave the order: the distance to the time of recording tells.
bool StampGate::shows_step(const Held& held) const {
  const Timestamp change = held.stamp - held.recorded - offset();
  const Timestamp period = median({gaps_.begin(), gaps_.end()});
  const Timestamp gap = held.stamp - *last_;
  if (gap > std::max<Timestamp>(3 * period, milliseconds(60)) && 2 * change > gap) return true;
  if (run_.empty() || run_.front().stamp > *last_) return false;
  // Set back by less than the run lasted: it goes on without a seam.
  const Timestamp of_run = run_.back().stamp - run_.back().recorded - offset();
  const Timestamp least = std::max<Timestamp>(period / 2, milliseconds(20));
  return change < -least && of_run < -least && held.stamp - run_.back().stamp <= 3 * period &&
         std::chrono::abs(change - of_run) <= std::max<Timestamp>(-change / 3, milliseconds(10));
}

/// In line: whatever was not so before is no run.
void StampGate::pass(Held held) {
  give_up_run();
  while (!parked_.empty() && parked_.front().stamp < held.stamp) {
    Held earlier = std::move(parked_.front());
    parked_.erase(parked_.begin());
    if (earlier.stamp > *last_) {
      release(std::move(earlier));
    } else {
      ++faults_.dropped;
    }
  }
  if (last_) push_recent(gaps_, held.stamp - *last_);
  push_recent(offsets_, held.stamp - held.recorded);
  release(std::move(held));
}

void StampGate::release(Held held) {
  last_ = held.stamp;
  stamp_of(held.message) = held.stamp;
  ready_.push_back(std::move(held.message));
}

void StampGate::hold(Held held) {
  if (!run_.empty()) {
    const Timestamp end = run_.back().stamp;
    if (held.stamp < end || held.stamp > end + max_gap()) give_up_run();
  }
  run_.push_back(std::move(held));
  if (run_believed()) believe_run();
}

bool StampGate::run_believed() const {
  if (run_.size() < kRunMessages) return false;
  const Timestamp recorded = run_.back().recorded - run_.front().recorded;
  return std::max(recorded, run_.back().stamp - run_.front().stamp) >= confirm_;
}

/// What another sensor found at the same time, if it is the same.
Timestamp StampGate::shared_step(Timestamp step, Timestamp recorded) const {
  for (const ClockStep& other : *steps_) {
    if (std::chrono::abs(other.recorded - recorded) <= seconds(5) &&
        std::chrono::abs(other.step - step) <= kSameClock) {
      return other.step;
    }
  }
  return step;
}

void StampGate::believe_run() {
  std::vector<Held> run = std::exchange(run_, {});
  std::vector<Timestamp> after;
  after.reserve(run.size());
  for (const Held& held : run) after.push_back(held.stamp - held.recorded);
  const Timestamp span = run.back().stamp - run.front().stamp;
  if (10 * span < run.back().recorded - run.front().recorded) {
    clock_stands_ = true;
    ++faults_.clock_steps;
    warn(fmt::format("the stamps of the {} stand still; the times of recording replace them",
                     sensor_));
  }
  Timestamp step = median(std::move(after)) - offset();
  const bool ahead = run.front().stamp > *last_;
  const bool pause = ahead && std::chrono::abs(step) <= kPauseTolerance;
  if (!clock_stands_ && !pause) {
    const Timestamp period = median({gaps_.begin(), gaps_.end()});
    // Where the times of recording do not tell, the run follows what passed.
    if (run.front().stamp - step <= *last_) step = run.front().stamp - *last_ - period;
    step = shared_step(step, run.front().recorded);
    steps_->push_back({.recorded = run.front().recorded, .step = step});
    shift_ -= step;
    ++faults_.clock_steps;
    warn(fmt::format("the {} clock was set {} by {:.3f} s; its stamps are shifted to go on",
                     sensor_,
                     step < Timestamp{} ? "back" : "ahead",
                     std::abs(to_seconds(step))));
  }
  for (Held& held : run) {
    if (clock_stands_) {
      held.stamp = held.recorded + offset();
    } else if (!pause) {
      held.stamp -= step;
    }
    if (held.stamp <= *last_) {
      ++faults_.dropped;
      continue;
    }
    if (!clock_stands_) push_recent(offsets_, held.stamp - held.recorded);
    release(std::move(held));
  }
}

void StampGate::give_up_run() {
  for (Held& held : std::exchange(run_, {})) {
    if (held.stamp == *last_) {
      ++faults_.repeated;
    } else if (held.stamp < *last_) {
      ++faults_.late;
    } else {
      ++faults_.ahead;
      park(std::move(held));
    }
  }
}

void StampGate::park(Held held) {
  const bool scan = std::holds_alternative<LidarScan>(held.message);
  const auto place = std::ranges::upper_bound(parked_, held.stamp, {}, &Held::stamp);
  parked_.insert(place, std::move(held));
  if (parked_.size() <= (scan ? kMaxParkedScans : kMaxParked)) return;
  parked_.pop_back();
  ++faults_.dropped;
}

void StampGate::finish() {
  if (!started_ && !first_.empty()) start();
  if (!run_.empty() && run_.front().stamp > *last_) {
    // The recording ends soon after a pause.
    const Timestamp step = run_.front().stamp - run_.front().recorded - offset();
    if (run_.size() > 1 && std::chrono::abs(step) <= kPauseTolerance) {
      for (Held& held : std::exchange(run_, {})) release(std::move(held));
    }
  }
  give_up_run();
  while (!parked_.empty() && last_ && parked_.front().stamp > *last_ &&
         parked_.front().stamp <= *last_ + max_gap()) {
    release(std::move(parked_.front()));
    parked_.erase(parked_.begin());
  }
  faults_.dropped += parked_.size();
  parked_.clear();
}

}  // namespace hybridfusion
