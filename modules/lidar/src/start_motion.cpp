#include "start_motion.hpp"

#include "deskew.hpp"
#include "scan_matching.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hybridfusion {
namespace {

// Matching finds its way over about half of this at 10 scans a second, so that one hypothesis is
// always near enough (measured: see find_start_motion's test).
constexpr double kSpeedStep_mps = 10.0;
constexpr double kMaxStartSpeed_mps = 30.0;
constexpr int kNumDirections = 8;
// Scans of the first look at all hypotheses, and of the second at those that remain.
constexpr std::size_t kFirstLook = 2;
constexpr std::size_t kSecondLook = 6;
constexpr std::size_t kNumKept = 4;
constexpr int kMaxRounds = 4;
// A point without a surface counts as this far off; so does one farther off.
constexpr double kUnmatched_m = 0.15;
// A start needs a hundredth of the points that a map does.
constexpr double kCoarser = 3.0;
// Motions nearer than this are one.
constexpr double kSameSpeed_mps = 0.5;
// What is found from few points of few scans scatters by some tenths; other places where the scans
// fit lie metres per second away.
constexpr double kAmbiguous_mps = 1.5;
// From so near one hypothesis settles into the other.
constexpr double kSameBasin_mps = 2.0;
constexpr double kSameTurn_radps = 0.05;
// Another motion must fit worse by this factor.
constexpr double kClearly = 1.05;
// Rest: but for what moves and for the edges of things. Streets driven along have 0.3 to 0.7.
constexpr double kMinShareAtRest = 0.9;
constexpr double kMinMatchedShare = 0.15;

/// What the motion may be off, for the filter that follows it.
struct Freedom {
  double velocity_mps = 0.0;
  double turn_rate_radps = 0.0;
};

constexpr Freedom kFirstFreedom = {.velocity_mps = 0.5 * kSpeedStep_mps, .turn_rate_radps = 0.3};
constexpr Freedom kSettling = {.velocity_mps = 0.25 * kSpeedStep_mps, .turn_rate_radps = 0.3};

struct Hypothesis {
  StartMotion motion = {};
  double matched_share = 0.0;
};

std::vector<PreparedScan> thinned(std::span<const PreparedScan> scans, double voxel_m) {
  std::vector<PreparedScan> out;
  for (const PreparedScan& scan : scans) {
    if (out.size() == kSecondLook) break;
    PreparedScan thin_scan{.stamp = scan.stamp, .begin = scan.begin, .end = scan.end};
    for (const std::size_t i : thin(scan.points, voxel_m)) {
      thin_scan.points.push_back(scan.points[i]);
    }
    out.push_back(std::move(thin_scan));
  }
  return out;
}

double bounded_misfit_m(double mean_residual_m, int num_matched, int num_points) {
  const double share = num_matched / std::max(1.0, static_cast<double>(num_points));
  return share * std::min(mean_residual_m, kUnmatched_m) + (1.0 - share) * kUnmatched_m;
}

/// Follows the scans from `start`; the motion becomes that at the first scan as the last ones know
/// it.
Hypothesis follow(const OdometryOptions& options,
                  const LidarRig& rig,
                  std::span<const PreparedScan> scans,
                  const StartMotion& start,
                  const Freedom& sigma) {
  const ImuBuffer no_imu;
  ScanFilter filter(options,
                    rig,
                    coasting_state(rig, start, sigma.velocity_mps, sigma.turn_rate_radps),
                    scans.front().begin,
                    MotionModel::kConstantVelocity);
  Hypothesis out;
  double sum_m = 0.0;
  double sum_share = 0.0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const ScanEstimate scan = filter.process(scans[i], no_imu);
    if (i == 0) continue;
    const ScanQuality& quality = scan.quality;
    sum_m += bounded_misfit_m(quality.mean_residual_m, quality.num_matched, quality.num_thinned);
    sum_share += quality.num_matched / std::max(1.0, static_cast<double>(quality.num_thinned));
    out.motion.velocity_mps = scan.velocity_in_map;
    out.motion.turn_rate_radps = -scan.gyro_bias_radps;
  }
  const auto count = static_cast<double>(scans.size() - 1);
  out.motion.misfit_m = sum_m / count;
  out.matched_share = sum_share / count;
  return out;
}

/// Share of the points of the last scan that lie where the first one has points, both as measured:
/// all of them at rest. (Planes do not tell rest: where a standing scanner's rings lie upon each
/// other there are only lines.)
double share_in_place(std::span<const PreparedScan> scans) {
  constexpr float kMaxRange_m = 20.0F;
  constexpr double kVoxel_m = 0.1;
  constexpr float kInPlace_m = 0.15F;
  VoxelMap map(kVoxel_m);
  std::vector<Eigen::Vector3f> points;
  for (const LidarPoint& point : scans.front().points) points.push_back(point.point_in_lidar);
  map.insert(points);
  std::size_t num_near = 0;
  std::size_t num_in_place = 0;
  MapNeighbors neighbors;
  for (const LidarPoint& point : scans.back().points) {
    if (point.point_in_lidar.norm() > kMaxRange_m) continue;
    ++num_near;
    map.nearest(point.point_in_lidar, 1, kInPlace_m, neighbors);
    if (neighbors.count > 0) ++num_in_place;
  }
  return num_near == 0 ? 0.0 : static_cast<double>(num_in_place) / static_cast<double>(num_near);
}

std::vector<StartMotion> first_guesses(const Eigen::Vector3d& up,
                                       const Eigen::Vector3d& turn_rate) {
  Eigen::Vector3d ahead = Eigen::Vector3d::UnitX() - up.x() * up;
  if (ahead.norm() < 0.1) ahead = Eigen::Vector3d::UnitY() - up.y() * up;
  ahead.normalize();
  const Eigen::Vector3d left = up.cross(ahead);
  std::vector<StartMotion> guesses{{.turn_rate_radps = turn_rate}};
  for (double speed = kSpeedStep_mps; speed <= kMaxStartSpeed_mps; speed += kSpeedStep_mps) {
    for (int i = 0; i < kNumDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kNumDirections;
      guesses.push_back({.velocity_mps = speed * (std::cos(angle) * ahead + std::sin(angle) * left),
                         .turn_rate_radps = turn_rate});
    }
  }
  return guesses;
}

bool fits_better(const Hypothesis& a, const Hypothesis& b) {
  return a.motion.misfit_m < b.motion.misfit_m;
}

bool same_motion(const StartMotion& a, const StartMotion& b, double speed_mps = kSameSpeed_mps) {
  return (a.velocity_mps - b.velocity_mps).norm() < speed_mps &&
         (a.turn_rate_radps - b.turn_rate_radps).norm() <
             kSameTurn_radps * speed_mps / kSameSpeed_mps;
}

/// Starts again with what the last pass found while that makes the scans fit better.
/// @param known  Nothing comes back when the first pass leads to the motion of one of these.
std::optional<Hypothesis> settle(const OdometryOptions& options,
                                 const LidarRig& rig,
                                 std::span<const PreparedScan> scans,
                                 const StartMotion& guess,
                                 std::span<const Hypothesis> known) {
  Hypothesis best = follow(options, rig, scans, guess, kSettling);
  for (int round = 1; round < kMaxRounds; ++round) {
    const bool is_known = std::ranges::any_of(
        known, [&](const Hypothesis& k) { return same_motion(k.motion, best.motion); });
    if (is_known) return std::nullopt;
    const Hypothesis next = follow(options, rig, scans, best.motion, kSettling);
    if (!fits_better(next, best)) break;
    const bool settled = same_motion(next.motion, best.motion);
    best = next;
    if (settled) break;
  }
  return best;
}

/// The best guesses of a first look, one of those that would settle into each other.
std::vector<StartMotion> promising(std::vector<Hypothesis> hypotheses) {
  std::ranges::stable_sort(hypotheses, fits_better);
  std::vector<StartMotion> kept;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (kept.size() == kNumKept) break;
    const bool is_known = std::ranges::any_of(kept, [&](const StartMotion& k) {
      return same_motion(k, hypothesis.motion, kSameBasin_mps);
    });
    if (!is_known) kept.push_back(hypothesis.motion);
  }
  return kept;
}

}  // namespace

StateEstimate coasting_state(const LidarRig& rig,
                             const StartMotion& motion,
                             double velocity_sigma_mps,
                             double turn_rate_sigma_radps) {
  StateEstimate out;
  out.state.velocity_in_map = motion.velocity_mps;
  out.state.gyro_bias = -motion.turn_rate_radps;
  out.state.imu_from_lidar = rig.imu_from_lidar.rotation.toRotationMatrix();
  out.state.lidar_in_imu = rig.imu_from_lidar.translation;
  const auto set = [&](int at, double sigma) {
    out.covariance.diagonal().segment<3>(at).setConstant(sigma * sigma);
  };
  set(err::kPosition, 1e-6);
  set(err::kRotation, 1e-6);
  set(err::kVelocity, velocity_sigma_mps);
  set(err::kGyroBias, turn_rate_sigma_radps);
  return out;
}

StartMotion find_start_motion(const OdometryOptions& options,
                              const LidarRig& rig,
                              std::span<const PreparedScan> scans,
                              const Eigen::Vector3d& up_in_imu,
                              const Eigen::Vector3d& turn_rate_radps) {
  if (scans.size() < 2) return {.problem = StartProblem::kFewScans};
  const std::size_t last = std::min(scans.size(), kSecondLook) - 1;
  StartMotion rest{.share_in_place = share_in_place(scans.first(last + 1))};
  if (rest.share_in_place > kMinShareAtRest) return rest;
  OdometryOptions coarse = options;
  coarse.filter.scan_voxel_m *= kCoarser;
  const std::vector<PreparedScan> thin_scans = thinned(scans, options.filter.scan_voxel_m);
  const std::span<const PreparedScan> all(thin_scans);
  const auto first = all.first(std::min(all.size(), kFirstLook));
  std::vector<Hypothesis> hypotheses;
  for (const StartMotion& guess : first_guesses(up_in_imu.normalized(), turn_rate_radps)) {
    hypotheses.push_back(follow(coarse, rig, first, guess, kFirstFreedom));
  }
  std::vector<Hypothesis> settled;
  for (const StartMotion& guess : promising(std::move(hypotheses))) {
    if (auto hypothesis = settle(coarse, rig, all, guess, settled)) settled.push_back(*hypothesis);
  }
  std::ranges::stable_sort(settled, fits_better);
  const Hypothesis& best = settled.front();
  StartMotion motion = best.motion;
  motion.share_in_place = rest.share_in_place;
  const bool ambiguous = std::ranges::any_of(settled, [&](const Hypothesis& other) {
    return !same_motion(other.motion, motion, kAmbiguous_mps) &&
           other.motion.misfit_m < kClearly * motion.misfit_m;
  });
  if (ambiguous) motion.problem = StartProblem::kAmbiguous;
  if (best.matched_share < kMinMatchedShare) motion.problem = StartProblem::kUnmatched;
  return motion;
}

}  // namespace hybridfusion
