#include "loop_verification.hpp"

#include "plan_search.hpp"
#include "submap_alignment.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr double kStretch_m = 10.0;
constexpr float kSubmapRadius_m = 40.0F;
constexpr double kMinPlanScore = 0.3;
constexpr std::size_t kMaxPlanMatches = 4;
constexpr double kMinOverlap = 0.4;
constexpr std::size_t kMinInliers = 60;
constexpr double kMinCosine2 = 0.015;
// A second place that fits nearly as well leaves the question open.
constexpr double kAmbiguous = 0.85;
// Submaps this far apart after alignment are different places.
constexpr double kSamePose_m = 1.0;
// What two good loops may differ by besides drift.
constexpr double kLoopNoise_m = 0.15;
constexpr double kLoopNoise_rad = 0.01;
constexpr double kMaxCycle_m = 150.0;
// Odometry drifts far less than its bound over short ways.
constexpr double kCycleShare = 0.5;

Expected<Submap> submap_around(const ScanStore& store, const DrivenWay& way, std::size_t scan) {
  const auto at = [&](double total_m) {
    return static_cast<std::size_t>(std::ranges::lower_bound(way.total_m, total_m) -
                                    way.total_m.begin());
  };
  const double middle_m = way.total_m[scan];
  return build_submap(store,
                      at(middle_m - kStretch_m),
                      std::max(at(middle_m + kStretch_m), scan + 1),
                      scan,
                      kSubmapRadius_m);
}

struct Fit {
  SubmapAlignment alignment = {};
  double score = 0.0;
};

/// Alignments from the best places of the plan search that pass every check, best first.
std::vector<Fit> fits_within(const LoopClosureOptions& options,
                             const Submap& target,
                             const Submap& source,
                             const PlanWindow& window) {
  std::vector<Fit> fits;
  for (const PlanMatch& match :
       search_plan(target, source, window, kMinPlanScore, kMaxPlanMatches)) {
    Rigid3 guess{.rotation = Eigen::Quaterniond(
                     Eigen::AngleAxisd(match.pose.yaw_rad, Eigen::Vector3d::UnitZ()))};
    guess.translation.head<2>() = match.pose.shift_m;
    const auto height_m = ground_offset(target, source, guess);
    if (!height_m) continue;
    guess.translation.z() = *height_m;
    const auto alignment = align_submaps(target, source, guess);
    if (!alignment || alignment->num_inliers < kMinInliers || alignment->overlap < kMinOverlap ||
        alignment->inlier_share < options.min_inlier_share ||
        alignment->min_cosine2 < kMinCosine2) {
      continue;
    }
    fits.push_back(
        {.alignment = *alignment, .score = alignment->overlap * alignment->inlier_share});
  }
  std::ranges::stable_sort(fits, std::greater{}, &Fit::score);
  return fits;
}

/// Rotation [rad] and translation [m] left after going round through both loops.
struct CycleError {
  double position_m = 0.0;
  double rotation_rad = 0.0;
};

CycleError cycle_error(std::span<const StoredScan> scans, const Loop& a, const Loop& b) {
  const auto pose = [&](std::size_t scan) -> const Rigid3& { return scans[scan].map_from_imu; };
  const Rigid3 by_first = pose(a.scans.first).inverse() * pose(b.scans.first);
  const Rigid3 by_second = pose(a.scans.second).inverse() * pose(b.scans.second);
  const Rigid3 left = a.first_from_second * by_second;
  const Rigid3 right = by_first * b.first_from_second;
  return {.position_m = (left.translation - right.translation).norm(),
          .rotation_rad = rotation_distance_rad(left.rotation, right.rotation)};
}

enum class Agreement { kUnknown, kAgree, kContradict };

Agreement agreement(const LoopClosureOptions& options,
                    std::span<const StoredScan> scans,
                    const DrivenWay& way,
                    const Loop& a,
                    const Loop& b) {
  double driven_m = 0.0;
  double blind_m = 0.0;
  for (const auto& [i, j] :
       {std::pair(a.scans.first, b.scans.first), std::pair(a.scans.second, b.scans.second)}) {
    driven_m += std::abs(way.total_m[i] - way.total_m[j]);
    blind_m += std::abs(way.blind_m[i] - way.blind_m[j]);
  }
  if (driven_m > kMaxCycle_m) return Agreement::kUnknown;
  const CycleError error = cycle_error(scans, a, b);
  const double drift_m =
      kCycleShare * (options.drift_ratio * driven_m + options.blind_drift_ratio * blind_m);
  return error.position_m <= kLoopNoise_m + drift_m && error.rotation_rad <= 2.0 * kLoopNoise_rad
             ? Agreement::kAgree
             : Agreement::kContradict;
}

}  // namespace

Expected<std::optional<Loop>> verify_loop(const LoopClosureOptions& options,
                                          const ScanStore& store,
                                          const DrivenWay& way,
                                          const LoopCandidate& candidate) {
  const std::vector<StoredScan>& scans = store.scans();
  HF_TRY(const Submap target, submap_around(store, way, candidate.first));
  HF_TRY(const Submap source, submap_around(store, way, candidate.second));
  const Rigid3& first = scans[candidate.first].map_from_imu;
  const Rigid3& second = scans[candidate.second].map_from_imu;
  const DriftBound bound = drift_bound(options, scans, way, candidate.first, candidate.second);
  const PlanWindow window{.centre = {.shift_m = (second.translation - first.translation).head<2>()},
                          .radius_m = bound.position_m,
                          .yaw_rad = bound.yaw_rad};
  const std::vector<Fit> fits = fits_within(options, target, source, window);
  if (fits.empty()) return std::nullopt;
  const Rigid3& best = fits.front().alignment.target_from_source;
  for (const Fit& other : fits) {
    const double apart_m =
        (other.alignment.target_from_source.translation - best.translation).norm();
    if (apart_m > kSamePose_m && other.score > kAmbiguous * fits.front().score) return std::nullopt;
  }
  // Submaps have the axes of the map.
  const Rigid3 first_from_target{.rotation = first.rotation.conjugate()};
  const Rigid3 source_from_second{.rotation = second.rotation};
  return Loop{.scans = candidate,
              .first_from_second = first_from_target * best * source_from_second,
              .score = fits.front().score};
}

std::vector<Loop> consistent_loops(const LoopClosureOptions& options,
                                   std::span<const StoredScan> scans,
                                   const DrivenWay& way,
                                   const std::vector<Loop>& loops) {
  // Loops in the order of their number of backers; each is taken unless it contradicts more of
  // those taken before than it agrees with.
  std::vector<std::size_t> order(loops.size());
  std::vector<int> backers(loops.size(), 0);
  std::vector<std::vector<Agreement>> table(loops.size());
  for (std::size_t a = 0; a < loops.size(); ++a) {
    order[a] = a;
    for (std::size_t b = 0; b < loops.size(); ++b) {
      table[a].push_back(a == b ? Agreement::kUnknown
                                : agreement(options, scans, way, loops[a], loops[b]));
      if (table[a][b] == Agreement::kAgree) ++backers[a];
    }
  }
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return backers[i]; });
  std::vector<std::size_t> taken;
  for (const std::size_t a : order) {
    if (backers[a] < options.min_support) break;
    const auto count = [&](Agreement kind) {
      return std::ranges::count_if(taken, [&](std::size_t b) { return table[a][b] == kind; });
    };
    if (count(Agreement::kContradict) <= count(Agreement::kAgree)) taken.push_back(a);
  }
  std::ranges::sort(taken);
  std::vector<Loop> out;
  for (const std::size_t i : taken) out.push_back(loops[i]);
  return out;
}

}  // namespace hybridfusion
