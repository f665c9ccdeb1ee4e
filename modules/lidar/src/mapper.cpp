#include "dense_map.hpp"
#include "drive_judgement.hpp"
#include "levelling.hpp"
#include "loop_closure.hpp"
#include "refinement.hpp"
#include "scan_store.hpp"
#include "structure_level.hpp"

#include <hybridfusion/lidar/mapper.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
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
  note(summary.num_scans_before_start,
       "scans at the start are left out: they do not fit each other under any motion");
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
  bool upside_down = false;

  /// The first error of the store; found by finish().
  Expected<void> stored = {};

  void collect();
  void judge();
  Expected<void> correct_drift(const RunContext& ctx);
  Expected<void> refine(const RunContext& ctx);
  Expected<void> level(const RunContext& ctx);
  void join_levels(double gravity_sigma_rad, const StructureLevel& structure);
};

void LidarMapper::Impl::collect() {
  for (const ScanEstimate& scan : odometry.take()) {
    if (stored) stored = store.add(scan);
    result.quality.push_back(scan.quality);
    result.covariances.push_back(scan.covariance);
  }
}

void LidarMapper::Impl::judge() {
  result.contradictions = contradictions_of(result.odometry, store.scans());
  if (upside_down) {
    result.contradictions.emplace_back(
        "the map lies upside down: the ground is above the LiDAR; the IMU (or, without one, the "
        "LiDAR) is mounted on its head, which imu_from_lidar in sensors.yaml must say");
  }
  result.longest_blind_s = longest_blind_s(result.quality);
  const bool blind = !(result.longest_blind_s <= options.max_blind_s);
  result.reliable = !blind && result.contradictions.empty();
  for (const std::string& contradiction : result.contradictions) {
    result.warnings.push_back(contradiction);
  }
  if (!blind) return;
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

/// The map is level by gravity: walls and ground take it nearer to theirs as sure as they are. When
/// they contradict, one of them is wrong, and nothing is mixed.
void LidarMapper::Impl::join_levels(double gravity_sigma_rad, const StructureLevel& structure) {
  constexpr double kSigmas = 4.0;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const double apart_rad = std::acos(std::clamp(structure.up_in_map.dot(up), -1.0, 1.0));
  if (apart_rad > kSigmas * std::hypot(gravity_sigma_rad, structure.sigma_rad)) {
    result.warnings.push_back(fmt::format(
        "gravity lies {:.1f} degrees off the vertical of walls and ground: they are steep here, or "
        "the accelerometer is wrong",
        apart_rad * 180.0 / std::numbers::pi));
    return;
  }
  const double by_gravity = 1.0 / (gravity_sigma_rad * gravity_sigma_rad);
  const double by_structure = 1.0 / (structure.sigma_rad * structure.sigma_rad);
  result.level_correction_rad +=
      turn_upright(by_gravity * up + by_structure * structure.up_in_map, store.scans());
  result.level_sigma_rad = 1.0 / std::sqrt(by_gravity + by_structure);
}

Expected<void> LidarMapper::Impl::level(const RunContext& ctx) {
  std::vector<StoredScan>& scans = store.scans();
  const MapLevel by_gravity = level_map(scans);
  result.level_correction_rad = by_gravity.turn_rad;
  result.level_sigma_rad = by_gravity.sigma_rad;
  // Where gravity is known that well, leaning walls and sloping streets add nothing.
  constexpr double kGoodLevel_rad = 0.003;
  const bool has_gravity = by_gravity.sigma_rad > 0.0;
  if (scans.empty() || (has_gravity && by_gravity.sigma_rad < kGoodLevel_rad)) return {};
  const std::vector<Segment> segments = cut_into_segments(scans, options.refine.segment_s);
  const Eigen::Vector3d lidar_up = scans.front().map_from_imu.rotation *
                                   (rig.imu_from_lidar.rotation * Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d about_up = has_gravity ? Eigen::Vector3d::UnitZ() : lidar_up;
  HF_TRY(const std::optional<StructureLevel> by_structure,
         level_by_structure(store, segments, about_up, ctx));
  if (by_structure && by_structure->upside_down) {
    upside_down = true;
    return {};
  }
  if (has_gravity) {
    if (by_structure) join_levels(by_gravity.sigma_rad, *by_structure);
    return {};
  }
  if (!by_structure) {
    result.warnings.emplace_back(
        "the map is not level: no IMU measured gravity, and neither walls nor ground are seen");
    return {};
  }
  result.level_correction_rad = turn_upright(by_structure->up_in_map, scans);
  result.level_sigma_rad = by_structure->sigma_rad;
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
  if (auto done = impl_->level(ctx); !done) return std::unexpected(done.error());
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
