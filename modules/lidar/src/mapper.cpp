#include "dense_map.hpp"
#include "levelling.hpp"
#include "loop_closure.hpp"
#include "refinement.hpp"
#include "scan_store.hpp"

#include <hybridfusion/lidar/mapper.hpp>

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};

void add_warnings(const OdometrySummary& summary, std::vector<std::string>& warnings) {
  warnings = summary.warnings;
  const auto note = [&](std::size_t count, const char* what) {
    if (count > 0) warnings.push_back(fmt::format("{} {}", count, what));
  };
  note(summary.num_imu_gaps, "gaps in the IMU stream were bridged");
  note(summary.num_lidar_gaps, "gaps between LiDAR scans were bridged by the IMU");
  note(summary.num_scans_dropped, "scans with repeated or late stamps were dropped");
  note(summary.num_imu_dropped, "IMU samples with repeated, late or invalid values were dropped");
  note(summary.num_unmatched_scans, "scans could not be matched: their poses are predictions");
  note(summary.num_degenerate_scans, "scans left a direction undetermined: held to the prediction");
}

/// From the first scan on; an end without matches counts too.
double longest_blind_s(std::span<const ScanQuality> quality) {
  constexpr auto kBlind = static_cast<std::uint32_t>(ScanFlag::kUnmatched) |
                          static_cast<std::uint32_t>(ScanFlag::kDiverged);
  double longest_s = 0.0;
  Timestamp last_seen = quality.empty() ? Timestamp{} : quality.front().time;
  for (const ScanQuality& scan : quality) {
    longest_s = std::max(longest_s, to_seconds(scan.time - last_seen));
    if ((scan.flags & kBlind) == 0) last_seen = scan.time;
  }
  return longest_s;
}

}  // namespace

struct LidarMapper::Impl {
  LidarOdometry odometry;
  OdometryOptions options;
  LidarRig rig;
  ScanStore store;
  MappingResult result = {};

  /// The first error of the store; found by finish().
  Expected<void> stored = {};

  void collect();
  void judge();
  Expected<void> correct_drift(const RunContext& ctx);
  Expected<void> refine(const RunContext& ctx);
};

void LidarMapper::Impl::collect() {
  for (const ScanEstimate& scan : odometry.take()) {
    if (stored) stored = store.add(scan);
    result.quality.push_back(scan.quality);
    result.covariances.push_back(scan.covariance);
  }
}

void LidarMapper::Impl::judge() {
  result.longest_blind_s = longest_blind_s(result.quality);
  result.reliable = result.longest_blind_s <= options.max_blind_s;
  if (result.reliable) return;
  result.warnings.push_back(
      fmt::format("no scan was located by its points for {:.1f} s (limit {} s, "
                  "lidar.odometry.max_blind_s): the trajectory is a guess from there on; was the "
                  "LiDAR covered or the view empty?",
                  result.longest_blind_s,
                  options.max_blind_s));
}

/// Only what ends the whole stage is an error: without loops the drive is as good as it was.
Expected<void> LidarMapper::Impl::correct_drift(const RunContext& ctx) {
  if (!options.loop_closure.enabled) return {};
  HF_TRY(const LoopClosureReport report,
         close_loops(options.loop_closure,
                     options.refine.segment_s,
                     {.fixes = result.gnss_fixes, .antenna_in_imu = rig.gnss_antenna_in_imu},
                     ctx,
                     store));
  result.num_loop_candidates = report.num_candidates;
  result.num_loops = report.num_loops;
  result.max_loop_error_m = report.max_error_m;
  result.loops_applied = report.applied;
  if (!report.contradiction.empty()) {
    result.warnings.push_back("loops are not closed: " + report.contradiction);
  }
  if (report.applied) {
    result.warnings.push_back(fmt::format(
        "odometry had drifted by up to {:.2f} m: {} places passed twice corrected it by "
        "up to {:.2f} m",
        report.max_error_m,
        report.num_loops,
        report.max_move_m));
  }
  for (std::size_t i = 0; i < store.scans().size(); ++i) {
    result.quality[i].flags = store.scans()[i].flags;
  }
  return {};
}

Expected<void> LidarMapper::Impl::refine(const RunContext& ctx) {
  if (!options.refine.enabled) return {};
  auto report = refine_poses(options.refine, ctx, store);
  if (report) {
    result.refine_iterations = report->iterations;
    result.num_refine_planes = report->num_planes;
    result.refine_rms_before_m = report->rms_before_m;
    result.refine_rms_after_m = report->rms_after_m;
    return {};
  }
  if (report.error().code == ErrorCode::kCancelled || report.error().code == ErrorCode::kIo) {
    return std::unexpected(std::move(report).error());
  }
  result.warnings.push_back("the poses are not refined: " + report.error().message);
  return {};
}

LidarMapper::LidarMapper(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LidarMapper::LidarMapper(LidarMapper&&) noexcept = default;
LidarMapper& LidarMapper::operator=(LidarMapper&&) noexcept = default;
LidarMapper::~LidarMapper() = default;

Expected<LidarMapper> LidarMapper::create(const OdometryOptions& options,
                                          const LidarRig& rig,
                                          const std::filesystem::path& scratch_folder) {
  HF_TRY(LidarOdometry odometry, LidarOdometry::create(options, rig));
  SpillFile spill;
  if (!scratch_folder.empty()) {
    HF_TRY(spill, SpillFile::create(scratch_folder));
  }
  return LidarMapper(std::make_unique<Impl>(
      Impl{.odometry = std::move(odometry),
           .options = options,
           .rig = rig,
           .store = ScanStore(options.max_points_per_scan, std::move(spill))}));
}

void LidarMapper::add(SensorMessage message) {
  std::visit(Overloaded{[&](ImuSample& sample) { impl_->odometry.add_imu(sample); },
                        [&](LidarScan& scan) { impl_->odometry.add_scan(std::move(scan)); },
                        [&](GnssFix& fix) { impl_->result.gnss_fixes.push_back(fix); }},
             message);
  impl_->collect();
}

std::size_t LidarMapper::num_located_scans() const {
  return impl_->store.scans().size();
}

Expected<MappingResult> LidarMapper::finish(const RunContext& ctx) {
  PointCloud map;
  auto result = finish(ctx, [&map](const PointCloud& piece) -> Expected<void> {
    map = concatenate(std::move(map), piece);
    return {};
  });
  if (result) result->map = std::move(map);
  return result;
}

Expected<MappingResult> LidarMapper::finish(const RunContext& ctx, const MapSink& sink) {
  if (auto finished = impl_->odometry.finish(); !finished) {
    return std::unexpected(std::move(finished).error());
  }
  impl_->collect();
  if (!impl_->stored) return std::unexpected(impl_->stored.error());
  MappingResult& result = impl_->result;
  ScanStore& store = impl_->store;
  result.odometry = impl_->odometry.summary();
  add_warnings(result.odometry, result.warnings);
  if (auto done = impl_->correct_drift(ctx); !done) return std::unexpected(done.error());
  if (auto done = impl_->refine(ctx); !done) return std::unexpected(done.error());
  const MapLevel level = level_map(store.scans());
  result.level_correction_rad = level.turn_rad;
  result.level_sigma_rad = level.sigma_rad;
  for (const StoredScan& scan : store.scans()) {
    result.trajectory.poses.push_back({.time = scan.time, .map_from_body = scan.map_from_imu});
  }
  auto built = build_dense_map(
      impl_->options.map, ctx, store, [&](const PointCloud& piece) -> Expected<void> {
        result.num_map_points += piece.size();
        return sink(piece);
      });
  if (!built) return std::unexpected(std::move(built).error());
  if (result.num_map_points == 0) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} located scans gave no map point, which takes returns of {} scans "
                            "within {} .. {} m; record some seconds of driving among buildings",
                            result.trajectory.poses.size(),
                            impl_->options.map.min_scans,
                            impl_->options.min_range_m,
                            impl_->options.map.max_range_m));
  }
  impl_->judge();
  return std::move(result);
}

std::string quality_csv_header() {
  return "time,points,matched,mean_residual_m,min_information,flags";
}

std::string quality_csv_row(const ScanQuality& quality) {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  return fmt::format("{}.{:09},{},{},{:.5f},{:.1f},{}",
                     quality.time.count() / kNsPerSecond,
                     quality.time.count() % kNsPerSecond,
                     quality.num_points,
                     quality.num_matched,
                     quality.mean_residual_m,
                     quality.min_information,
                     flags_text(quality.flags));
}

}  // namespace hybridfusion
