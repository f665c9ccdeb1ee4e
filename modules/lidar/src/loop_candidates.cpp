#include "loop_candidates.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kKeyframe_m = 4.0;
constexpr std::size_t kMaxVisits = 2;
// Places this near each other show the same things from most sides.
constexpr double kSamePlace_m = 8.0;
// Earlier places farther apart on the way belong to different visits.
constexpr double kVisitGap_m = 3.0 * kKeyframe_m;
// Drift that is there from the start.
constexpr double kBaseDrift_m = 1.0;
constexpr double kBaseYaw_rad = 0.03;
constexpr double kMaxYaw_rad = 0.35;

bool is_blind(std::uint32_t flags) {
  constexpr std::uint32_t kBlind = static_cast<std::uint32_t>(ScanFlag::kDegenerate) |
                                   static_cast<std::uint32_t>(ScanFlag::kUnmatched) |
                                   static_cast<std::uint32_t>(ScanFlag::kDiverged) |
                                   static_cast<std::uint32_t>(ScanFlag::kFewPoints) |
                                   static_cast<std::uint32_t>(ScanFlag::kLidarGap);
  return (flags & kBlind) != 0;
}

std::vector<std::size_t> keyframes(const DrivenWay& way) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < way.total_m.size(); ++i) {
    if (out.empty() || way.total_m[i] - way.total_m[out.back()] >= kKeyframe_m) out.push_back(i);
  }
  return out;
}

struct Visit {
  std::size_t scan = 0;
  double distance_m = 0.0;
};

}  // namespace

DrivenWay driven_way(std::span<const StoredScan> scans) {
  DrivenWay way;
  double total_m = 0.0;
  double blind_m = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (i > 0) {
      const double step_m =
          (scans[i].map_from_imu.translation - scans[i - 1].map_from_imu.translation).norm();
      total_m += step_m;
      if (is_blind(scans[i].flags)) blind_m += step_m;
    }
    way.total_m.push_back(total_m);
    way.blind_m.push_back(blind_m);
  }
  return way;
}

DriftBound drift_bound(const LoopClosureOptions& options,
                       std::span<const StoredScan> scans,
                       const DrivenWay& way,
                       std::size_t first,
                       std::size_t second) {
  const double driven_m = way.total_m[second] - way.total_m[first];
  const double blind_m = way.blind_m[second] - way.blind_m[first];
  const double time_s = to_seconds(scans[second].time - scans[first].time);
  return {.position_m = std::min(
              options.max_drift_m,
              kBaseDrift_m + options.drift_ratio * driven_m + options.blind_drift_ratio * blind_m),
          .yaw_rad = std::min(kMaxYaw_rad, kBaseYaw_rad + options.yaw_drift_radps * time_s)};
}

std::vector<LoopCandidate> find_loop_candidates(const LoopClosureOptions& options,
                                                std::span<const StoredScan> scans,
                                                const DrivenWay& way) {
  std::vector<LoopCandidate> all;
  const std::vector<std::size_t> frames = keyframes(way);
  for (const std::size_t second : frames) {
    std::vector<Visit> visits;
    double last_m = -kVisitGap_m;
    for (const std::size_t first : frames) {
      if (way.total_m[second] - way.total_m[first] < options.min_path_m) break;
      const double distance_m =
          (scans[first].map_from_imu.translation - scans[second].map_from_imu.translation)
              .head<2>()
              .norm();
      const double drift_m = drift_bound(options, scans, way, first, second).position_m;
      if (distance_m > kSamePlace_m + drift_m) continue;
      if (visits.empty() || way.total_m[first] - last_m > kVisitGap_m) {
        visits.push_back({.scan = first, .distance_m = distance_m});
      } else if (distance_m < visits.back().distance_m) {
        visits.back() = {.scan = first, .distance_m = distance_m};
      }
      last_m = way.total_m[first];
    }
    std::ranges::stable_sort(visits, {}, &Visit::distance_m);
    if (visits.size() > kMaxVisits) visits.resize(kMaxVisits);
    for (const Visit& visit : visits) all.push_back({.first = visit.scan, .second = second});
  }
  const auto limit = static_cast<std::size_t>(options.max_candidates);
  if (all.size() <= limit) return all;
  std::vector<LoopCandidate> spread;
  for (std::size_t i = 0; i < limit; ++i) spread.push_back(all[i * all.size() / limit]);
  return spread;
}

}  // namespace hybridfusion
