#include "point_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace hybridfusion {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr std::size_t kSectors = 36;
constexpr std::size_t kMinSectors = 27;  // 270 degrees

/// Angle brought into [-pi, pi).
[[nodiscard]] double wrapped(double angle_rad) {
  return angle_rad - kTurn_rad * std::floor(angle_rad / kTurn_rad + 0.5);
}

[[nodiscard]] double azimuth_rad(const LidarPoint& point) {
  return std::atan2(static_cast<double>(point.point_in_lidar.y()),
                    static_cast<double>(point.point_in_lidar.x()));
}

[[nodiscard]] bool is_turn(std::span<const LidarPoint> points) {
  std::array<bool, kSectors> seen = {};
  for (const LidarPoint& point : points) {
    if (!has_return(point)) continue;
    const double share = azimuth_rad(point) / kTurn_rad + 0.5;
    seen[std::min(static_cast<std::size_t>(share * kSectors), kSectors - 1)] = true;
  }
  return std::ranges::count(seen, true) >= static_cast<std::ptrdiff_t>(kMinSectors);
}

struct Sweep {
  double direction = 0.0;  ///< +1 counter-clockwise, -1 clockwise, 0 unknown.
  double start_rad = 0.0;
};

/// Follows each ring (messages come ring by ring or column by column): the small steps between its
/// points tell the direction, its first point where the turn starts.
[[nodiscard]] Sweep find_sweep(std::span<const LidarPoint> points) {
  constexpr double kSmallStep_rad = 0.35;
  std::map<std::uint16_t, double> last_rad;
  std::vector<double> starts_rad;
  double progress_rad = 0.0;
  for (const LidarPoint& point : points) {
    if (!has_return(point)) continue;
    const double azimuth = azimuth_rad(point);
    const auto [last, is_first] = last_rad.try_emplace(point.ring, azimuth);
    if (is_first) {
      starts_rad.push_back(azimuth);
      continue;
    }
    const double step = wrapped(azimuth - last->second);
    if (std::abs(step) < kSmallStep_rad) progress_rad += step;
    last->second = azimuth;
  }
  Sweep sweep;
  if (progress_rad == 0.0) return sweep;
  sweep.direction = progress_rad > 0.0 ? 1.0 : -1.0;
  // Rings without early returns start late: the earliest ring is the start.
  double earliest = 0.0;
  for (const double start : starts_rad) {
    earliest = std::min(earliest, sweep.direction * wrapped(start - starts_rad.front()));
  }
  constexpr double kMargin_rad = 0.01;  // lasers of one column do not point the same way exactly
  sweep.start_rad = starts_rad.front() + sweep.direction * (earliest - kMargin_rad);
  return sweep;
}

}  // namespace

std::optional<std::vector<std::int32_t>> offsets_from_azimuth(std::span<const LidarPoint> points,
                                                              Timestamp period) {
  if (!is_turn(points)) return std::nullopt;
  const Sweep sweep = find_sweep(points);
  if (sweep.direction == 0.0) return std::nullopt;
  std::vector<std::int32_t> offsets_ns(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has_return(points[i])) continue;
    const double turned = sweep.direction * (azimuth_rad(points[i]) - sweep.start_rad) / kTurn_rad;
    const double share = turned - std::floor(turned);
    offsets_ns[i] = static_cast<std::int32_t>(share * static_cast<double>(period.count()));
  }
  return offsets_ns;
}

}  // namespace hybridfusion
