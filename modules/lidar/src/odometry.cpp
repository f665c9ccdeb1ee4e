#include "deskew.hpp"
#include "odometry_impl.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Spans that no scan has: such point times are not times.
constexpr double kMaxScan_s = 0.6;
constexpr double kMinScanShare = 0.05;
// A scan this far ahead of the IMU is a wrong stamp when the next one is back to normal.
constexpr double kFarAhead_s = 1.0;
constexpr int kLateUntilStep = 5;
// With this many scans waiting the IMU is not late but gone.
constexpr std::size_t kMaxWaiting = 60;
constexpr double kSameClock_s = 0.2;

constexpr std::uint32_t bit(ScanFlag flag) {
  return static_cast<std::uint32_t>(flag);
}

}  // namespace

PreparedScan LidarOdometry::Impl::prepare(LidarScan scan) {
  PreparedScan out{.stamp = scan.stamp + shift};
  out.points = std::move(scan.points);
  const std::size_t num_returns = out.points.size();
  const std::size_t num_dropped = clean_scan(options.min_range_m, options.max_range_m, out.points);
  summary.num_points_dropped += num_dropped;
  if (2 * num_dropped > num_returns) out.flags |= bit(ScanFlag::kBadPoints);
  if (out.points.size() < static_cast<std::size_t>(options.filter.min_matches)) {
    out.flags |= bit(ScanFlag::kFewPoints);
  }
  // The filter matches some thousand points; more than this only cost time (see the option).
  decimate(static_cast<std::size_t>(options.max_odometry_points), out.points);
  if (out.points.size() > 1) {
    const double span_s =
        1e-9 * (static_cast<double>(out.points.back().offset_ns) - out.points.front().offset_ns);
    const bool too_short = span_s < kMinScanShare * std::max(typical_period_s, 1e-3);
    if (too_short || span_s > std::max(kMaxScan_s, 1.5 * typical_period_s)) {
      out.flags |= bit(ScanFlag::kNoPointTimes);
      for (LidarPoint& point : out.points) point.offset_ns = 0;
    }
  }
  if (out.points.empty()) {
    out.begin = out.stamp;
    out.end = out.stamp + from_seconds(typical_span_s > 0.0 ? typical_span_s : 0.1);
  } else {
    out.begin = out.stamp + Timestamp(out.points.front().offset_ns);
    out.end = out.stamp + Timestamp(out.points.back().offset_ns);
  }
  return out;
}

bool LidarOdometry::Impl::accept(PreparedScan& scan) {
  if (num_accepted > 0 && scan.end <= last_end) {
    const bool last_was_ahead =
        !waiting.empty() && !imu.empty() && to_seconds(last_end - imu.last_time()) > kFarAhead_s;
    if (last_was_ahead) {
      waiting.pop_back();
      ++summary.num_scans_dropped;
      last_end = waiting.empty() ? (filter ? filter->time() : scan.begin) : waiting.back().end;
    }
  }
  if (num_accepted > 0 && scan.end <= last_end) {
    // Now and then a duplicate; a run of late stamps is a clock that was set back for good.
    if (++num_late < kLateUntilStep) {
      ++summary.num_scans_dropped;
      return false;
    }
    Timestamp step = last_end + from_seconds(num_late * typical_period_s) - scan.end;
    // Both sensors on one clock: the IMU, which samples finer, knows the step better.
    if (std::abs(to_seconds(imu.shift() - shift - step)) < kSameClock_s) step = imu.shift() - shift;
    shift += step;
    scan.stamp += step;
    scan.begin += step;
    scan.end += step;
    scan.flags |= bit(ScanFlag::kClockStep);
    summary.warnings.push_back(
        fmt::format("the LiDAR clock went back; its stamps are shifted by {:.3f} s from scan {} on",
                    to_seconds(step),
                    num_accepted));
  }
  num_late = 0;
  return true;
}

void LidarOdometry::Impl::note_period(PreparedScan& scan) {
  if (num_accepted > 0) {
    const double period_s = to_seconds(scan.end - last_end);
    if (num_accepted > 3 && period_s > std::max(0.25, 2.5 * typical_period_s)) {
      scan.flags |= bit(ScanFlag::kLidarGap);
    } else {
      typical_period_s =
          typical_period_s == 0.0 ? period_s : 0.9 * typical_period_s + 0.1 * period_s;
    }
  }
  const double span_s = to_seconds(scan.end - scan.begin);
  typical_span_s = typical_span_s == 0.0 ? span_s : 0.9 * typical_span_s + 0.1 * span_s;
  last_end = scan.end;
  ++num_accepted;
}

void LidarOdometry::Impl::process_front() {
  PreparedScan scan = std::move(waiting.front());
  waiting.pop_front();
  done.push_back(filter->process(scan, imu));
  if (filter->model() == MotionModel::kInertial) rig_check.add(done.back());
  watch_imu(done.back());
  const std::uint32_t flags = done.back().quality.flags;
  ++summary.num_scans;
  summary.num_map_points = filter->map().size();
  if ((flags & (bit(ScanFlag::kUnmatched) | bit(ScanFlag::kDiverged))) != 0) {
    ++summary.num_unmatched_scans;
  }
  if ((flags & bit(ScanFlag::kLidarGap)) != 0) ++summary.num_lidar_gaps;
  if ((flags & bit(ScanFlag::kDegenerate)) != 0) ++summary.num_degenerate_scans;
  const Timestamp needed =
      waiting.empty() ? filter->time() : std::min(filter->time(), waiting.front().begin);
  imu.forget_before(needed - from_seconds(kMaxScan_s));
}

void LidarOdometry::Impl::drain(bool last) {
  while (!waiting.empty()) {
    const bool forced = last || waiting.size() > kMaxWaiting;
    if (wants_imu()) {
      if (imu.empty() && !forced) return;
      const bool covered = !imu.empty() && imu.last_time() >= waiting.front().end;
      if (!covered && !forced) return;
      if (!covered && !imu.empty() && !summary.imu_ended) {
        summary.imu_ended = true;
        summary.warnings.push_back(
            fmt::format("the IMU stops at scan {}: later motion comes from the LiDAR alone",
                        summary.num_scans));
      }
    }
    if (filter) {
      process_front();
    } else if (!try_start(forced)) {
      if (!forced) return;
    }
  }
}

LidarOdometry::LidarOdometry(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LidarOdometry::LidarOdometry(LidarOdometry&&) noexcept = default;
LidarOdometry& LidarOdometry::operator=(LidarOdometry&&) noexcept = default;
LidarOdometry::~LidarOdometry() = default;

Expected<LidarOdometry> LidarOdometry::create(const OdometryOptions& options, const LidarRig& rig) {
  if (auto valid = validate_odometry(options); !valid) return std::unexpected(valid.error());
  if (auto valid = validate(rig); !valid) return std::unexpected(valid.error());
  return LidarOdometry(std::make_unique<Impl>(Impl{.options = options, .rig = rig}));
}

void LidarOdometry::add_imu(const ImuSample& sample) {
  ImuSample shifted = sample;
  shifted.time += from_seconds(impl_->options.imu_time_offset_s);
  ++impl_->summary.num_imu_samples;
  switch (impl_->imu.add(shifted)) {
    case ImuBuffer::Verdict::kDropped:
      ++impl_->summary.num_imu_dropped;
      break;
    case ImuBuffer::Verdict::kClockStep:
      impl_->summary.warnings.emplace_back("the IMU clock went back; its stamps are shifted");
      break;
    case ImuBuffer::Verdict::kTaken:
    case ImuBuffer::Verdict::kHeld:
      break;
  }
  impl_->summary.num_imu_gaps = impl_->imu.num_gaps();
  impl_->drain(false);
}

void LidarOdometry::add_scan(LidarScan scan) {
  PreparedScan prepared = impl_->prepare(std::move(scan));
  if (!impl_->accept(prepared)) return;
  impl_->note_period(prepared);
  impl_->waiting.push_back(std::move(prepared));
  impl_->drain(false);
}

std::vector<ScanEstimate> LidarOdometry::take() {
  return std::exchange(impl_->done, {});
}

Expected<void> LidarOdometry::finish() {
  if (impl_->num_accepted == 0) {
    return fail(ErrorCode::kInsufficient, "the recording has no LiDAR scan");
  }
  impl_->drain(true);
  if (impl_->summary.num_scans == 0) {
    return fail(ErrorCode::kDegenerate,
                fmt::format("the motion of the LiDAR was not found in any of {} scans: they do not "
                            "fit each other; is the view free, and do the scans follow each other "
                            "within a fraction of a second?",
                            impl_->num_accepted));
  }
  constexpr double kSlowImu_hz = 50.0;
  const double interval_s = impl_->imu.typical_interval_s();
  if (interval_s * kSlowImu_hz > 1.0 && impl_->wants_imu()) {
    impl_->summary.warnings.push_back(
        fmt::format("the IMU delivers only {:.0f} samples a second: turns within a scan are not "
                    "known; 100 or more are needed for full accuracy",
                    1.0 / interval_s));
  }
  impl_->name_imu_fault();
  impl_->summary.used_imu = impl_->filter && impl_->filter->model() == MotionModel::kInertial;
  if (!impl_->options.filter.estimate_extrinsic && impl_->summary.imu_doubts.empty()) {
    const auto warnings = impl_->rig_check.warnings();
    impl_->summary.warnings.insert(impl_->summary.warnings.end(), warnings.begin(), warnings.end());
  }
  return {};
}

const OdometrySummary& LidarOdometry::summary() const {
  return impl_->summary;
}

}  // namespace hybridfusion
