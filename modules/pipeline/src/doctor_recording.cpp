#include "doctor_checks.hpp"
#include "recording_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kGravity_mps2 = 9.80665;
constexpr double kMinDuration_s = 5.0;
constexpr double kMinReturns = 200.0;
constexpr double kMaxMedianRange_m = 300.0;
constexpr double kGoodImuRate_hz = 90.0;
constexpr double kMinImuRate_hz = 20.0;
constexpr double kMaxRotation_radps = 3.5;  // 200 deg/s: no vehicle, hardly a hand
constexpr double kMinCoveredShare = 0.5;
constexpr double kMaxImuGap_s = 0.05;
constexpr double kMaxLidarGap_s = 0.35;
constexpr double kMinTrack_m = 20.0;

void check_imu(const RecordingStatistics& statistics,
               const RecordingSummary& summary,
               Diagnosis& diagnosis) {
  FindingList& findings = diagnosis.findings;
  const double period_s = statistics.imu.period_s();
  const double rate_hz = period_s > 0.0 ? 1.0 / period_s : 0.0;
  if (rate_hz < kGoodImuRate_hz) {
    findings.add(rate_hz < kMinImuRate_hz ? "recording.imu_too_slow" : "recording.imu_rate",
                 fmt::format("the IMU sends {:.1f} samples a second", rate_hz));
  }
  const ImuDialect& dialect = summary.imu_dialect;
  const double force = quantile_of(statistics.force_mps2, 0.5);
  if (dialect.in_g || (dialect.force_median == 0.0 && force > 0.8 && force < 1.2)) {
    findings.add("recording.imu_in_g",
                 fmt::format("the acceleration is {:.3f} in the median", force));
  } else if (force < 0.7 * kGravity_mps2 || force > 1.3 * kGravity_mps2) {
    findings.add("recording.no_gravity",
                 fmt::format("the acceleration is {:.3f} in the median, {:.2f} m/s^2 is right",
                             force,
                             kGravity_mps2));
  }
  if (dialect.without_force + dialect.without_rate > 0) {
    findings.add("recording.imu_parts",
                 fmt::format("{} samples without acceleration, {} without angular velocity",
                             dialect.without_force,
                             dialect.without_rate));
  }
  const double rotation = quantile_of(statistics.rotation_radps, 0.95);
  if (rotation > kMaxRotation_radps) {
    findings.add("recording.gyro_units",
                 fmt::format("5 % of the angular velocities exceed {:.1f} rad/s", rotation));
  }
}

void report_stamps(const RecordingSummary& summary, FindingList& findings) {
  const StampFaults& imu = summary.imu_stamps;
  const StampFaults& lidar = summary.lidar_stamps;
  const auto displaced = [](const StampFaults& faults) { return faults.late + faults.ahead; };
  if (displaced(imu) + displaced(lidar) > 0) {
    findings.add("recording.stamps_back",
                 fmt::format("{} IMU samples and {} scans are out of order by their stamps",
                             displaced(imu),
                             displaced(lidar)));
  }
  if (imu.repeated + lidar.repeated > 0) {
    findings.add("recording.stamps_repeat",
                 fmt::format("{} IMU samples and {} scans have the stamp of the one before",
                             imu.repeated,
                             lidar.repeated));
  }
  if (imu.missing + lidar.missing > 0) {
    findings.add("recording.no_stamps",
                 fmt::format("{} IMU samples and {} scans", imu.missing, lidar.missing));
  }
  if (imu.clock_steps + lidar.clock_steps > 0) {
    findings.add("recording.clock_set",
                 fmt::format("{} times by the stamps of the IMU, {} times by those of the LiDAR",
                             imu.clock_steps,
                             lidar.clock_steps));
  }
}

void check_timing(const RecordingStatistics& statistics,
                  const RecordingSummary& summary,
                  Diagnosis& diagnosis) {
  FindingList& findings = diagnosis.findings;
  const StampStatistics& imu = statistics.imu;
  const StampStatistics& lidar = statistics.lidar;
  const Timestamp begin = std::max(imu.first(), lidar.first());
  const Timestamp end = std::min(imu.last(), lidar.last());
  const double covered_s = std::max(0.0, to_seconds(end - begin));
  if (covered_s < kMinCoveredShare * lidar.duration_s() || end < begin) {
    findings.add("recording.clocks",
                 fmt::format("the scans last {:.1f} s, the IMU covers {:.1f} s of that; the first "
                             "scan is {:+.1f} s off the first IMU sample",
                             lidar.duration_s(),
                             covered_s,
                             to_seconds(lidar.first() - imu.first())));
  }
  if (lidar.duration_s() < kMinDuration_s) {
    findings.add("recording.short",
                 fmt::format("{} scans over {:.1f} s", lidar.count(), lidar.duration_s()));
  }
  const auto report_gaps = [&](std::string_view id, const StampStatistics& stamps, double limit_s) {
    const double longest_s = std::max(limit_s, 3.5 * stamps.period_s());
    const auto gaps = stamps.gaps(longest_s);
    if (gaps.count == 0) return;
    findings.add(id,
                 fmt::format("{} gaps of more than {:.2f} s, the longest {:.2f} s",
                             gaps.count,
                             longest_s,
                             gaps.longest_s));
  };
  report_gaps("recording.imu_gaps", imu, kMaxImuGap_s);
  report_gaps("recording.lidar_gaps", lidar, kMaxLidarGap_s);
  report_stamps(summary, findings);
}

void check_scans(const RecordingStatistics& statistics,
                 const RecordingSummary& summary,
                 Diagnosis& diagnosis) {
  if (summary.point_time.find("made up") != std::string::npos) {
    diagnosis.findings.add("recording.no_point_time",
                           summary.lidar_topic + ": " + summary.point_time);
  }
  const double returns = quantile_of(statistics.returns, 0.5);
  if (returns < kMinReturns) {
    diagnosis.findings.add("recording.few_returns",
                           fmt::format("{:.0f} returns a scan in the median", returns));
  }
  const double range_m = quantile_of(statistics.ranges_m, 0.5);
  if (range_m > kMaxMedianRange_m) {
    diagnosis.findings.add("recording.lidar_units",
                           fmt::format("ranges of {:.0f} in the median", range_m));
  }
}

void check_gnss(const RecordingStatistics& statistics,
                const RecordingSummary& summary,
                Diagnosis& diagnosis) {
  if (summary.gnss_topic.empty() || summary.gnss_topic == "none") {
    diagnosis.findings.add("recording.no_gnss", "there is no GNSS topic in use");
    return;
  }
  if (statistics.fixes.empty()) {
    diagnosis.findings.add("recording.no_fix", summary.gnss_topic + " holds no usable fix");
    return;
  }
  double extent_m = 0.0;
  for (const GeodeticPosition& fix : statistics.fixes) {
    extent_m =
        std::max(extent_m, enu_from_geodetic(statistics.fixes.front(), fix).head<2>().norm());
  }
  diagnosis.facts.push_back(fmt::format("{}: {} fixes, up to {:.0f} m from the first",
                                        summary.gnss_topic,
                                        statistics.fixes.size(),
                                        extent_m));
  if (extent_m < kMinTrack_m) {
    diagnosis.findings.add("recording.no_motion",
                           fmt::format("the GNSS track reaches {:.1f} m from its start", extent_m));
  }
}

/// The finding that a recording without the topics asked for is.
std::string_view topic_fault(const RecordingSummary& summary, const RecordingOptions& options) {
  const bool no_lidar = options.lidar_topic.empty() && summary.lidar_topic.empty();
  return no_lidar ? "recording.no_lidar" : "recording.wrong_topic";
}

/// The finding that an error of reading is.
std::string_view reading_fault(const Error& error, const RecordingSummary& summary) {
  if (summary.undecided_frames) return "recording.several_sensors";
  if (error.code != ErrorCode::kNotFound) return "recording.unreadable";
  return error.message.find("frame_id") != std::string::npos ? "recording.wrong_topic"
                                                             : "recording.no_point_time";
}

Expected<RecordingStatistics> read_all(ScanSource& source,
                                       std::uint64_t expected_scans,
                                       Diagnosis& diagnosis,
                                       const RunContext& ctx) {
  RecordingStatistics statistics;
  std::int64_t scans = 0;
  while (true) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while reading the recording");
    const auto message = source.next();
    if (!message) {
      diagnosis.findings.add(reading_fault(message.error(), source.summary()),
                             message.error().message);
      break;
    }
    if (!*message) break;
    statistics.add(**message);
    if (!std::holds_alternative<LidarScan>(**message)) continue;
    ctx.report({.stage = "doctor/recording",
                .done = ++scans,
                .total = static_cast<std::int64_t>(expected_scans)});
  }
  return statistics;
}

void report_reading(const RecordingSummary& summary,
                    const std::filesystem::path& bag,
                    Diagnosis& diagnosis) {
  if (summary.truncated) {
    diagnosis.findings.add(
        "recording.truncated",
        fmt::format("{} is cut off after {} scans", bag.string(), summary.num_scans));
  }
  if (summary.num_damaged_messages > 0) {
    diagnosis.findings.add("recording.damaged",
                           fmt::format("{} damaged messages", summary.num_damaged_messages));
  }
}

/// Of all files that a recording consists of.
std::uint64_t size_of(const std::filesystem::path& bag) {
  std::uint64_t bytes = 0;
  const auto files = recording_files(bag);
  if (!files) return 0;
  for (const std::filesystem::path& file : *files) {
    std::error_code code;
    const std::uint64_t size = std::filesystem::file_size(file, code);
    if (!code) bytes += size;
  }
  return bytes;
}

}  // namespace

Expected<RecordingEvidence> check_recording(const std::filesystem::path& bag,
                                            const RecordingOptions& options,
                                            Diagnosis& diagnosis,
                                            const RunContext& ctx) {
  RecordingEvidence evidence;
  const auto inspected = inspect_recording(bag);
  if (!inspected) {
    diagnosis.findings.add("recording.unreadable", inspected.error().message);
    return evidence;
  }
  evidence.size_bytes = size_of(bag);
  auto source = open_recording(bag, options);
  if (!source) {
    diagnosis.findings.add(topic_fault(*inspected, options), source.error().message);
    return evidence;
  }
  std::uint64_t expected_scans = 0;
  for (const RecordingTopic& topic : inspected->topics) {
    if (topic.name == (*source)->summary().lidar_topic) expected_scans = topic.messages.value_or(0);
  }
  HF_TRY(RecordingStatistics statistics, read_all(**source, expected_scans, diagnosis, ctx));
  const RecordingSummary summary = (*source)->summary();
  report_reading(summary, bag, diagnosis);
  if (diagnosis.findings.contains("recording.several_sensors")) return evidence;
  if (statistics.lidar.count() == 0) {
    diagnosis.findings.add("recording.no_scans",
                           fmt::format("no scan on {} can be used", summary.lidar_topic));
    return evidence;
  }
  const bool has_imu = statistics.imu.count() > 0;
  if (!has_imu) {
    diagnosis.findings.add("recording.no_imu",
                           summary.imu_topic.empty()
                               ? std::string("the recording has no topic of that type")
                               : fmt::format("no sample on {} can be used", summary.imu_topic));
  }
  diagnosis.facts.push_back(
      fmt::format("{}: {} scans, {:.1f} s, {:.1f} Hz, {:.0f} returns each; point time: {}",
                  summary.lidar_topic,
                  statistics.lidar.count(),
                  statistics.lidar.duration_s(),
                  1.0 / std::max(1e-9, statistics.lidar.period_s()),
                  quantile_of(statistics.returns, 0.5),
                  summary.point_time));
  if (has_imu) {
    diagnosis.facts.push_back(fmt::format("{}: {} samples, {:.1f} Hz",
                                          summary.imu_topic,
                                          statistics.imu.count(),
                                          1.0 / std::max(1e-9, statistics.imu.period_s())));
    check_timing(statistics, summary, diagnosis);
    check_imu(statistics, summary, diagnosis);
  }
  check_scans(statistics, summary, diagnosis);
  check_gnss(statistics, summary, diagnosis);
  evidence.fixes = std::move(statistics.fixes);
  return evidence;
}

}  // namespace hybridfusion
