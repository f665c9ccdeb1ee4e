#include "point_time.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// Velodyne, Ouster, Hesai and RoboSense, Livox; in the order of preference.
constexpr std::array<std::string_view, 8> kTimeFields = {"time",
                                                         "t",
                                                         "timestamp",
                                                         "time_stamp",
                                                         "offset_time",
                                                         "timeoffset",
                                                         "time_offset",
                                                         "timestamps"};

struct Unit {
  std::string_view name;
  double ns;
};
constexpr std::array<Unit, 4> kUnits = {{{"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1.0}}};

// Spans that count as a scan. The bounds are a factor of 1000 apart, as the units are, so that one
// unit fits; real scans (0.01 .. 0.5 s) are well inside.
constexpr double kMinScan_ns = 8e5;
constexpr double kMaxScan_ns = 8e8;
constexpr double kMaxOffset_ns = 1e9;
constexpr Timestamp kDefaultPeriod = milliseconds(100);
constexpr std::size_t kMaxStampGaps = 15;
// A single one may be a scan of which hardly anything came back.
constexpr int kMisfitsToTell = 3;

[[nodiscard]] std::optional<Unit> unit_named(std::string_view name) {
  const auto found = std::ranges::find(kUnits, name, &Unit::name);
  return found == kUnits.end() ? std::nullopt : std::optional(*found);
}

[[nodiscard]] std::optional<Unit> unit_by_span(double span) {
  for (const Unit& unit : kUnits) {
    if (span * unit.ns >= kMinScan_ns && span * unit.ns < kMaxScan_ns) return unit;
  }
  return std::nullopt;
}

/// Whole nanoseconds of `value` units. Integer and fractional parts apart, so that absolute times
/// keep the precision they have. Nothing beyond the range of a Timestamp.
[[nodiscard]] std::optional<Timestamp> to_timestamp(double value, double unit_ns) {
  if (!(std::abs(value) * unit_ns < 9e18)) return std::nullopt;  // also NaN
  const double whole = std::floor(value);
  return Timestamp(static_cast<std::int64_t>(whole) * static_cast<std::int64_t>(unit_ns) +
                   std::llround((value - whole) * unit_ns));
}

}  // namespace

bool has_return(const LidarPoint& point) {
  constexpr float kMinRange_m = 1e-3F;
  return point.point_in_lidar.allFinite() &&
         point.point_in_lidar.squaredNorm() > kMinRange_m * kMinRange_m;
}

std::optional<std::size_t> PointTimeReader::choose_field(std::span<const std::string> names) const {
  const auto index_of = [&](auto&& matches) -> std::optional<std::size_t> {
    const auto found = std::ranges::find_if(names, matches);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
  };
  if (!options_.field.empty()) {
    return index_of([this](const std::string& name) { return name == options_.field; });
  }
  for (const std::string_view known : kTimeFields) {
    const auto found = index_of([&](const std::string& name) { return lower_case(name) == known; });
    if (found) return found;
  }
  return std::nullopt;
}

PointTimeReader::Extent PointTimeReader::measure(const LidarScan& scan,
                                                 std::span<const double> values) {
  Extent extent;
  std::set<double> different;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!has_return(scan.points[i]) || !std::isfinite(values[i])) continue;
    extent.low = extent.count == 0 ? values[i] : std::min(extent.low, values[i]);
    extent.high = extent.count == 0 ? values[i] : std::max(extent.high, values[i]);
    ++extent.count;
    if (different.size() < 4) different.insert(values[i]);
  }
  extent.varies = different.size() >= 4;
  return extent;
}

/// Nothing when this scan does not tell.
std::optional<PointTimeReader::Format> PointTimeReader::detect(const LidarScan& scan,
                                                               const RawPointTimes& raw,
                                                               const Extent& extent) {
  const std::optional<Unit> unit =
      options_.unit.empty() ? unit_by_span(extent.high - extent.low) : unit_named(options_.unit);
  if (!unit) return std::nullopt;
  Format format = {.unit_ns = unit->ns};
  const double farthest_ns = std::max(std::abs(extent.low), std::abs(extent.high)) * unit->ns;
  std::string_view meaning = "relative to the scan's stamp";
  if (farthest_ns > kMaxOffset_ns) {
    const auto first = to_timestamp(extent.low, unit->ns);
    const bool same_clock = first && std::chrono::abs(*first - scan.stamp) <= seconds(1);
    format.clock = same_clock ? Clock::kAbsolute : Clock::kForeign;
    meaning =
        same_clock ? "absolute" : "a clock of its own, first point taken for the scan's stamp";
    if (!same_clock) {
      warn_once(
          fmt::format("the clock of the point times (field '{}') is not that of the scan stamps; "
                      "the stamp is taken for the time of the first point",
                      raw.field));
    }
  }
  description_ =
      fmt::format("field '{}' ({}, {}, {})", raw.field, to_string(raw.type), unit->name, meaning);
  return format;
}

void PointTimeReader::convert(LidarScan& scan,
                              std::span<const double> values,
                              const Extent& extent) {
  Timestamp zero{};
  if (format_->clock == Clock::kAbsolute) {
    // The points know better than a header of which the stamp is missing or displaced.
    const auto first = to_timestamp(extent.low, format_->unit_ns);
    const auto last = to_timestamp(extent.high, format_->unit_ns);
    const bool one_scan = first && last && *last - *first < seconds(1);
    if (one_scan && std::chrono::abs(*first - scan.stamp) > seconds(1)) scan.stamp = *first;
    zero = scan.stamp;
  }
  if (format_->clock == Clock::kForeign) {
    zero = to_timestamp(extent.low, format_->unit_ns).value_or(Timestamp{});
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto time = to_timestamp(values[i], format_->unit_ns);
    if (!time) continue;
    const std::int64_t offset_ns = (*time - zero).count();
    if (std::abs(static_cast<double>(offset_ns)) > kMaxOffset_ns) continue;
    scan.points[kept] = scan.points[i];
    scan.points[kept++].offset_ns = static_cast<std::int32_t>(offset_ns);
  }
  if (kept < scan.points.size()) {
    warn_once("points whose time is more than 1 s off their scan's stamp are dropped");
    scan.points.resize(kept);
  }
}

void PointTimeReader::synthesize(LidarScan& scan, std::string_view why) {
  made_up_ = true;
  const Timestamp period = scan_period();
  const auto offsets = offsets_from_azimuth(scan.points, period);
  const std::string text = fmt::format(
      "{}; times are made up from the {} of the points", why, offsets ? "azimuth" : "order");
  warn_once(text);
  if (!format_ || num_misfits_ >= kMisfitsToTell) description_ = text;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    scan.points[i].offset_ns =
        offsets ? (*offsets)[i]
                : static_cast<std::int32_t>(period.count() * static_cast<std::int64_t>(i) /
                                            static_cast<std::int64_t>(scan.points.size()));
  }
}

void PointTimeReader::assign(LidarScan& scan, const RawPointTimes& raw) {
  note_stamp(scan.stamp);
  if (scan.points.empty()) return;
  if (raw.values.empty()) {
    return synthesize(scan, raw.missing.empty() ? "the scans have no time per point" : raw.missing);
  }
  const Extent extent = measure(scan, raw.values);
  if (!format_ && extent.varies) format_ = detect(scan, raw, extent);
  if (!extent.varies && (!format_ || extent.count >= 4)) {
    return synthesize(scan,
                      fmt::format("the point times of field '{}' are all the same", raw.field));
  }
  if (format_ && extent.varies) num_misfits_ = fits_period(extent) ? 0 : num_misfits_ + 1;
  if (format_ && num_misfits_ < kMisfitsToTell) return convert(scan, raw.values, extent);
  synthesize(scan,
             fmt::format("the point times of field '{}' do not span a scan in s, ms, us or ns "
                         "(set point_time_unit when they are right all the same)",
                         raw.field));
}

/// A unit that was given is obeyed.
bool PointTimeReader::fits_period(const Extent& extent) const {
  if (!options_.unit.empty() || stamp_gaps_.empty()) return true;
  constexpr double kMinShare = 0.05;
  constexpr double kMaxShare = 1.5;
  const double span_ns = (extent.high - extent.low) * format_->unit_ns;
  const auto period_ns = static_cast<double>(scan_period().count());
  return span_ns >= kMinShare * period_ns &&
         span_ns <= std::max(kMaxScan_ns, kMaxShare * period_ns);
}

void PointTimeReader::note_stamp(Timestamp stamp) {
  if (last_stamp_ && stamp > *last_stamp_ && stamp - *last_stamp_ < seconds(1)) {
    stamp_gaps_.push_back(stamp - *last_stamp_);
    if (stamp_gaps_.size() > kMaxStampGaps) stamp_gaps_.pop_front();
  }
  last_stamp_ = stamp;
}

Timestamp PointTimeReader::scan_period() const {
  if (stamp_gaps_.empty()) return kDefaultPeriod;
  std::vector<Timestamp> gaps(stamp_gaps_.begin(), stamp_gaps_.end());
  std::ranges::nth_element(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2));
  return gaps[gaps.size() / 2];
}

std::vector<std::string> PointTimeReader::take_warnings() {
  return std::exchange(warnings_, {});
}

void PointTimeReader::warn_once(std::string text) {
  if (told_.insert(text).second) warnings_.push_back(std::move(text));
}

}  // namespace hybridfusion
