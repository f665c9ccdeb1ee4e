#include "loop_closure.hpp"

#include "loop_graph.hpp"
#include "loop_verification.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

// Loops open by less are left to the adjustment of planes, which sees them as one wall.
constexpr double kClosed_m = 0.04;
constexpr double kClosed_rad = 0.003;
// Odometry that loops would bend by more than this many deviations in all contradicts them: streets
// that look alike have passed every test of their looks. True loops take 3 to 7 on drives that
// were 0.2 to 0.8 m off.
constexpr double kMaxStrain_sigmas = 12.0;
constexpr double kFlagged_m = 0.03;
constexpr std::size_t kPairsAtOnce = 32;

Expected<std::vector<Loop>> verified_loops(const LoopClosureOptions& options,
                                           const RunContext& ctx,
                                           const ScanStore& store,
                                           const DrivenWay& way,
                                           const std::vector<LoopCandidate>& candidates) {
  std::vector<Expected<std::optional<Loop>>> found(kPairsAtOnce);
  std::vector<Loop> loops;
  for (std::size_t first = 0; first < candidates.size(); first += kPairsAtOnce) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped by the caller");
    const std::size_t count = std::min(kPairsAtOnce, candidates.size() - first);
    parallel_for(ctx, count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        found[i] = verify_loop(options, store, way, candidates[first + i]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      if (!found[i]) return std::unexpected(found[i].error());
      if (*found[i]) loops.push_back(**found[i]);
    }
    ctx.report({.stage = "lidar/loops",
                .done = static_cast<std::int64_t>(first + count),
                .total = static_cast<std::int64_t>(candidates.size())});
  }
  return loops;
}

/// By how much a loop is open at the present poses.
struct OpenLoop {
  double position_m = 0.0;
  double rotation_rad = 0.0;
};

OpenLoop open_by(const Loop& loop, std::span<const StoredScan> scans) {
  const Rigid3 present =
      scans[loop.scans.first].map_from_imu.inverse() * scans[loop.scans.second].map_from_imu;
  return {.position_m = (present.translation - loop.first_from_second.translation).norm(),
          .rotation_rad = rotation_distance_rad(present.rotation, loop.first_from_second.rotation)};
}

/// Moves the scans to the solved graph and flags those whose motion changed.
double apply(const std::vector<Segment>& segments,
             const std::vector<Rigid3>& before,
             const std::vector<Rigid3>& after,
             std::vector<StoredScan>& scans) {
  move_scans(segments, after, scans);
  double max_move_m = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    max_move_m = std::max(max_move_m, (after[i].translation - before[i].translation).norm());
    if (i == 0) continue;
    const Rigid3 was = before[i - 1].inverse() * before[i];
    const Rigid3 is = after[i - 1].inverse() * after[i];
    if ((is.translation - was.translation).norm() < kFlagged_m) continue;
    for (std::size_t s = segments[i - 1].anchor; s <= segments[i].anchor; ++s) {
      scans[s].flags |= static_cast<std::uint32_t>(ScanFlag::kLoopCorrected);
    }
  }
  return max_move_m;
}

}  // namespace

Expected<LoopClosureReport> close_loops(const LoopClosureOptions& options,
                                        double segment_s,
                                        const GnssTrack& gnss,
                                        const RunContext& ctx,
                                        ScanStore& store) {
  LoopClosureReport report;
  std::vector<StoredScan>& scans = store.scans();
  const DrivenWay way = driven_way(scans);
  const std::vector<LoopCandidate> candidates = find_loop_candidates(options, scans, way);
  report.num_candidates = candidates.size();
  if (candidates.empty()) return report;
  HF_TRY(const std::vector<Loop> verified, verified_loops(options, ctx, store, way, candidates));
  const std::vector<Loop> loops = consistent_loops(options, scans, way, verified);
  report.num_loops = loops.size();
  double max_turn_rad = 0.0;
  for (const Loop& loop : loops) {
    const OpenLoop open = open_by(loop, scans);
    report.max_error_m = std::max(report.max_error_m, open.position_m);
    max_turn_rad = std::max(max_turn_rad, open.rotation_rad);
  }
  if (report.max_error_m < kClosed_m && max_turn_rad < kClosed_rad) return report;
  const std::vector<Segment> segments = cut_into_segments(scans, segment_s);
  HF_TRY(PoseGraph graph, build_loop_graph(store, segments, loops, ctx));
  add_gnss(gnss, segments, scans, graph);
  const std::vector<Rigid3> before = anchor_poses(segments, scans);
  std::vector<Rigid3> after = before;
  auto solved = optimize_pose_graph(graph, options.robust_sigmas, after);
  if (!solved) {
    report.contradiction = solved.error().message;
    return report;
  }
  const double strain = total_strain(graph.odometry, after);
  if (!(strain <= kMaxStrain_sigmas)) {
    report.contradiction = fmt::format(
        "{} loops are open by up to {:.2f} m and would bend the odometry by {:.0f} standard "
        "deviations, more than the {:.0f} allowed",
        loops.size(),
        report.max_error_m,
        strain,
        kMaxStrain_sigmas);
    return report;
  }
  report.max_move_m = apply(segments, before, after, scans);
  report.applied = true;
  return report;
}

}  // namespace hybridfusion
