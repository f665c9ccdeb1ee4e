#include "json_text.hpp"
#include "map_summary.hpp"
#include "recording_setup.hpp"
#include "stage_runner.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/scan_source.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/lidar/gnss_alignment.hpp>
#include <hybridfusion/lidar/mapper.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::int64_t expected_scans(const RecordingSummary& summary) {
  for (const RecordingTopic& topic : summary.topics) {
    if (topic.name == summary.lidar_topic)
      return static_cast<std::int64_t>(topic.messages.value_or(0));
  }
  return 0;
}

Expected<MappingResult> map_recording(ScanSource& source,
                                      const OdometryOptions& options,
                                      const LidarRig& rig,
                                      const Workspace& workspace,
                                      const RunContext& ctx) {
  HF_TRY(LidarMapper mapper, LidarMapper::create(options, rig, workspace.path("lidar")));
  const std::int64_t total = expected_scans(source.summary());
  std::int64_t scans = 0;
  while (true) {
    if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while reading the recording");
    HF_TRY(std::optional<SensorMessage> message, source.next());
    if (!message) break;
    if (std::holds_alternative<LidarScan>(*message)) {
      ctx.report({.stage = "map/odometry", .done = ++scans, .total = total});
    }
    mapper.add(*std::move(message));
  }
  HF_TRY(PlyPieceWriter map, PlyPieceWriter::create(workspace.path(workspace_file::kMap)));
  auto mapping = mapper.finish(ctx, [&map](const PointCloud& piece) -> Expected<void> {
    map.add(piece);
    return {};
  });
  if (!mapping) return mapping;
  if (auto written = map.commit(); !written) return std::unexpected(written.error());
  return mapping;
}

Expected<void> write_map_files(const Workspace& workspace, const MappingResult& mapping) {
  auto written = write_tum(workspace.path(workspace_file::kTrajectory), mapping.trajectory);
  if (!written) return written;
  if (mapping.level_sigma_rad > 0.0) {
    const Json level = {{"vertical_sigma_deg", 180.0 / std::numbers::pi * mapping.level_sigma_rad}};
    written = write_file_atomically(workspace.path(workspace_file::kLevel), to_text(level));
    if (!written) return written;
  }
  std::string csv = quality_csv_header() + "\n";
  for (const ScanQuality& quality : mapping.quality) csv += quality_csv_row(quality) + "\n";
  return write_file_atomically(workspace.path(workspace_file::kQuality), csv);
}

/// The plane in which the drive is placed: that of the photos when they have one, so that both
/// clouds share it; else the plane at the first usable fix.
Expected<GeodeticOrigin> enu_origin(const Workspace& workspace, const std::vector<GnssFix>& fixes) {
  if (workspace.has(workspace_file::kOrigin)) {
    return read_origin(workspace.path(workspace_file::kOrigin));
  }
  for (const GnssFix& fix : fixes) {
    const GeodeticPosition& position = fix.position;
    if (std::isfinite(position.latitude_deg + position.longitude_deg + position.altitude_m)) {
      return position;
    }
  }
  return fail(ErrorCode::kInsufficient, "the recording holds no GNSS fix");
}

Json gnss_json(const GnssAlignment& alignment, const GeodeticOrigin& origin) {
  Json covariance = Json::array();
  for (Eigen::Index r = 0; r < 4; ++r) {
    for (Eigen::Index c = 0; c < 4; ++c) covariance.push_back(alignment.covariance(r, c));
  }
  Json residuals = Json::array();
  for (const GnssResidual& residual : alignment.residuals) {
    residuals.push_back({{"time", to_seconds(residual.time)},
                         {"enu_m", {residual.enu_m.x(), residual.enu_m.y(), residual.enu_m.z()}},
                         {"used", residual.used}});
  }
  constexpr double kDegPerRad = 180.0 / std::numbers::pi;
  return {{"enu_from_map", matrix_json(alignment.enu_from_map)},
          {"origin",
           {{"latitude_deg", origin.latitude_deg},
            {"longitude_deg", origin.longitude_deg},
            {"altitude_m", origin.altitude_m},
            {"datum", "WGS84"}}},
          {"covariance", covariance},
          {"covariance_order", {"east_m", "north_m", "up_m", "yaw_rad"}},
          {"heading_sigma_deg", kDegPerRad * std::sqrt(alignment.covariance(3, 3))},
          {"horizontal_rms_m", alignment.rms_horizontal_m},
          {"vertical_rms_m", alignment.rms_vertical_m},
          {"num_used", alignment.num_used},
          {"num_outliers", alignment.num_outliers},
          {"track_extent_m", alignment.track_extent_m},
          {"residuals", residuals}};
}

/// gnss.json, or {"reason"} and no file when GNSS does not place the map.
Expected<Json> place_by_gnss(const Workspace& workspace,
                             const MappingResult& mapping,
                             const Eigen::Vector3d& antenna_in_imu,
                             const GnssAlignmentOptions& options,
                             const RunContext& ctx) {
  const auto origin = enu_origin(workspace, mapping.gnss_fixes);
  if (!origin && origin.error().code != ErrorCode::kInsufficient) {
    return std::unexpected(origin.error());
  }
  const auto alignment =
      origin ? align_gnss(mapping.trajectory, mapping.gnss_fixes, *origin, antenna_in_imu, options)
             : Expected<GnssAlignment>(std::unexpected(origin.error()));
  if (!alignment) {
    ctx.warn("the map is not georeferenced: " + alignment.error().message);
    return Json{{"reason", alignment.error().message}};
  }
  if (!alignment->contradiction.empty()) {
    ctx.warn("the map is not georeferenced: " + alignment->contradiction);
    return Json{{"reason", alignment->contradiction}, {"contradicts", true}};
  }
  Json json = gnss_json(*alignment, *origin);
  if (auto written = write_file_atomically(workspace.path(workspace_file::kGnss), to_text(json));
      !written) {
    return std::unexpected(written.error());
  }
  json.erase("residuals");
  return json;
}

std::unexpected<Error> no_imu(const std::filesystem::path& bag, const RecordingSummary& recording) {
  std::string topics;
  for (const RecordingTopic& topic : recording.topics) {
    topics += fmt::format("{}{} ({})", topics.empty() ? "" : ", ", topic.name, topic.type);
  }
  return fail(
      ErrorCode::kNotFound,
      fmt::format("{}: no IMU (sensor_msgs/Imu), which lidar.imu=required asks for; topics: "
                  "{}; record the IMU, or map from the LiDAR alone with --set "
                  "lidar.imu=auto",
                  bag.string(),
                  topics));
}

Expected<StageResult> map_into(Project& project,
                               const std::filesystem::path& bag,
                               const RecordingSetup& setup,
                               const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  const LidarStageOptions& options = project.options.lidar;
  HF_TRY(const std::unique_ptr<ScanSource> source, open_recording(bag, setup.recording, ctx));
  LidarRig rig = setup.rig;
  if (source->summary().imu_topic.empty()) {
    if (options.imu == "required") return no_imu(bag, source->summary());
    rig.imu_use = ImuUse::kNone;
  }
  if (auto made = workspace.make_folder("lidar"); !made) return std::unexpected(made.error());
  HF_TRY(const MappingResult mapping, map_recording(*source, setup.odometry, rig, workspace, ctx));
  if (options.imu == "required" && mapping.odometry.num_imu_samples == 0) {
    return no_imu(bag, source->summary());
  }
  const RecordingSummary recording = source->summary();
  for (const std::string& warning : recording.warnings) {
    ctx.warn(fmt::format("{}: {}", bag.string(), warning));
  }
  for (const std::string& warning : mapping.warnings) ctx.warn(warning);
  if (recording.truncated) {
    ctx.warn(
        fmt::format("{}: the recording is cut off; what precedes the cut is used", bag.string()));
  }
  HF_TRY(const Json gnss,
         place_by_gnss(workspace, mapping, setup.rig.gnss_antenna_in_imu, options.gnss, ctx));
  if (auto written = write_map_files(workspace, mapping); !written) {
    return std::unexpected(written.error());
  }
  return map_summary(mapping, recording, gnss);
}

}  // namespace

Expected<StageOutcome> map_stage(Project& project,
                                 const std::filesystem::path& bag,
                                 const std::optional<std::filesystem::path>& sensors,
                                 const RunContext& ctx) {
  HF_TRY(const RecordingSetup setup, recording_setup(project, bag, sensors));
  StagePlan plan{.stage = "map",
                 .option_groups = {"lidar"},
                 .inputs = {},
                 .outputs = {workspace_file::kTrajectory,
                             workspace_file::kMap,
                             workspace_file::kQuality,
                             workspace_file::kLevel,
                             workspace_file::kGnss}};
  HF_TRY(plan.inputs, recording_files(bag));
  if (setup.sensors_path) plan.inputs.push_back(*setup.sensors_path);
  if (project.workspace.has(workspace_file::kOrigin)) {
    plan.inputs.push_back(project.workspace.path(workspace_file::kOrigin));
  }
  return run_stage(project, plan, ctx, [&] { return map_into(project, bag, setup, ctx); });
}

}  // namespace hybridfusion
