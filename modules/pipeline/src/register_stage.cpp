#include "coarse_pose.hpp"
#include "json_text.hpp"
#include "level_correction.hpp"
#include "registration_json.hpp"
#include "stage_runner.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/registration/fuse_clouds.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <chrono>
#include <numbers>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Files of the workspaces around the two clouds that help, when they exist.
struct Companions {
  std::optional<std::filesystem::path> trajectory = {};  ///< Beside L.
  std::optional<std::filesystem::path> gnss = {};        ///< Beside L.
  std::optional<std::filesystem::path> level = {};       ///< Beside L.
  std::optional<std::filesystem::path> origin = {};      ///< Beside G.
  std::optional<std::filesystem::path> covariance = {};  ///< Beside G.
};

std::optional<std::filesystem::path> beside(const std::filesystem::path& file,
                                            std::string_view name) {
  const std::filesystem::path path = file.parent_path() / name;
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return std::nullopt;
  return path;
}

Companions companions_of(const RegisterInputs& inputs) {
  Companions found = {.trajectory = beside(inputs.lidar, "trajectory.tum"),
                      .gnss = beside(inputs.lidar, "gnss.json"),
                      .level = beside(inputs.lidar, "level.json"),
                      .origin = beside(inputs.vision, "origin.json"),
                      .covariance = beside(inputs.vision, "pose_covariance.csv")};
  // Without the poses the covariances say nothing.
  if (!beside(inputs.vision, "images.txt")) found.covariance.reset();
  return found;
}

Expected<std::vector<Eigen::Vector3d>> sensor_positions(const Companions& companions) {
  std::vector<Eigen::Vector3d> positions;
  if (!companions.trajectory) return positions;
  HF_TRY(const Trajectory trajectory, read_tum(*companions.trajectory));
  for (const StampedPose& pose : trajectory.poses) {
    positions.push_back(pose.map_from_body.translation);
  }
  return positions;
}

/// A registration that could not even be tried is a refusal too; only a stop is not.
Expected<RegistrationResult> registered_or_refused(const PointCloud& vision,
                                                   const PointCloud& lidar,
                                                   const RegistrationInput& input,
                                                   const RegistrationOptions& options,
                                                   const RunContext& ctx) {
  auto result = register_cross_source(vision, lidar, input, options, ctx);
  if (result) return result;
  const ErrorCode code = result.error().code;
  if (code != ErrorCode::kInsufficient && code != ErrorCode::kDegenerate) return result;
  return RegistrationResult{.status = RegistrationStatus::kRefused,
                            .reason = result.error().message,
                            .method = options.method};
}

/// Scales G about the registered LiDAR cloud, so that vision_from_lidar stays as it is.
Sim3 fused_from_vision(const RegistrationResult& result, bool rescale) {
  if (!rescale || !result.vision_scale_supported) return {};
  const Sim3 vision_from_lidar{.rotation = result.vision_from_lidar.rotation,
                               .translation = result.vision_from_lidar.translation};
  return vision_from_lidar * result.lidar_from_vision_similarity;
}

Expected<void> write_fused(const Workspace& workspace,
                           const PointCloud& fused,
                           const std::optional<std::filesystem::path>& origin_path) {
  if (auto made = workspace.make_folder("fused"); !made) return made;
  if (auto written = write_ply(workspace.path(workspace_file::kFusedPly), fused); !written) {
    return written;
  }
  LasWriteOptions las;
  if (origin_path) {
    HF_TRY(const GeodeticOrigin origin, read_origin(*origin_path));
    las.georeference = LasGeoreference{origin};
  }
  return write_las(workspace.path(workspace_file::kFusedLas), fused, las);
}

/// The fused frame and what it stands for: the frame of G, with the scale and the vertical of L
/// where the registration supports them.
struct FusedFrame {
  Sim3 rescale = {};  ///< Identity when G keeps its scale.
  LevelCorrection level = {};
  Sim3 from_vision = {};
  Rigid3 from_lidar = {};
};

Expected<FusedFrame> fused_frame(const RegistrationResult& result,
                                 const Companions& companions,
                                 const FusionStageOptions& options,
                                 const RunContext& ctx) {
  FusedFrame frame{.rescale = fused_from_vision(result, options.rescale_vision)};
  if (options.level_vision) {
    HF_TRY(LevelEvidence evidence, read_level_evidence(companions.covariance, companions.level));
    // GNSS holds the cameras where the model had them before it was rescaled about L.
    if (evidence.cameras_middle) {
      evidence.cameras_middle = frame.rescale * *evidence.cameras_middle;
    }
    frame.level = level_correction(result, evidence);
    if (!frame.level.applied) ctx.info("vertical of the photos kept: " + frame.level.reason);
  }
  const Rigid3& level = frame.level.level_from_vision;
  frame.from_vision =
      Sim3{.rotation = level.rotation, .translation = level.translation} * frame.rescale;
  frame.from_lidar = level * result.vision_from_lidar;
  return frame;
}

/// What the user reads of an accepted registration, a line each.
std::vector<std::string> summary_of(const RegistrationResult& result,
                                    const FuseResult& fused,
                                    const FusedFrame& frame,
                                    double seconds) {
  std::vector<std::string> lines = {
      fmt::format(
          "method {}, confidence {:.2f}, {:.1f} s", result.method, result.confidence, seconds),
      result.vision_scale_supported
          ? fmt::format("photo model scale {:+.3f} % against the LiDAR cloud{}",
                        100.0 * (1.0 / result.vision_scale - 1.0),
                        frame.rescale.scale != 1.0 ? ", corrected in the fused cloud" : "")
          : std::string("photo model scale could not be told from the LiDAR cloud"),
      fmt::format("{} fused points; {} vision and {} LiDAR points were doubles",
                  fused.cloud.size(),
                  fused.vision_dropped,
                  fused.lidar_dropped)};
  if (frame.level.applied) {
    lines.push_back(fmt::format(
        "photo model tilted by {:.3f} deg against gravity in the LiDAR map, levelled in the fused "
        "cloud",
        180.0 / std::numbers::pi * frame.level.tilt_rad));
  }
  if (result.drift.supported) {
    lines.push_back(
        fmt::format("LiDAR cloud bent by up to {:.2f} m along the drive, straightened in the fused "
                    "cloud: held-out distances {:.3f} -> {:.3f} m",
                    result.drift.size_m,
                    result.drift.held_out_before_m,
                    result.drift.held_out_after_m));
  }
  if (!result.reason.empty()) lines.push_back(result.reason);
  return lines;
}

/// Fuses and writes; adds what it did to `json` and to the summary.
Expected<StageResult> fuse_registered(Project& project,
                                      const Companions& companions,
                                      const PointCloud& vision,
                                      PointCloud lidar,
                                      const RegistrationInput& known,
                                      const RegistrationResult& result,
                                      const RunContext& ctx,
                                      Json& json) {
  const FusionStageOptions& options = project.options.fusion;
  HF_TRY(const FusedFrame frame, fused_frame(result, companions, options, ctx));
  HF_TRY(lidar, without_drift(std::move(lidar), result.drift, known.sensor_positions, ctx));
  HF_TRY(const FuseResult fused,
         fuse_clouds(vision, lidar, frame.from_lidar, frame.from_vision, options.clouds, ctx));
  if (auto written = write_fused(project.workspace, fused.cloud, companions.origin); !written) {
    return std::unexpected(written.error());
  }
  json["fused_from_vision"] = matrix_json(frame.from_vision);
  json["fused_from_lidar"] = matrix_json(frame.from_lidar);
  json["level"] = json_of(frame.level);
  json["num_fused_points"] = fused.cloud.size();
  json["num_vision_points_dropped"] = fused.vision_dropped;
  json["num_lidar_points_dropped"] = fused.lidar_dropped;
  return StageResult{.summary = summary_of(result, fused, frame, json.value("seconds", 0.0))};
}

Expected<StageResult> register_into(Project& project,
                                    const RegisterInputs& inputs,
                                    const Companions& companions,
                                    const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  HF_TRY(const PointCloud vision, read_point_cloud(inputs.vision));
  HF_TRY(PointCloud lidar, read_point_cloud(inputs.lidar));
  for (const auto& [path, cloud] : {std::pair{&inputs.vision, &vision}, {&inputs.lidar, &lidar}}) {
    if (!cloud->empty()) continue;
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: the cloud holds no point; check how it was made", path->string()));
  }
  HF_TRY(const CoarsePose coarse,
         coarse_pose(inputs, companions.origin, companions.gnss, project.options.registration));
  RegistrationInput known{.vision_from_lidar_initial = coarse.vision_from_lidar,
                          .initial_covariance = coarse.covariance};
  HF_TRY(known.sensor_positions, sensor_positions(companions));
  RegistrationOptions options = project.options.registration;
  options.max_yaw_rad = coarse.max_yaw_rad;
  ctx.info("coarse pose: " + coarse.source);
  const auto start = std::chrono::steady_clock::now();
  HF_TRY(const RegistrationResult result,
         registered_or_refused(vision, lidar, known, options, ctx));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  Json json = registration_json(result);
  json["seconds"] = seconds.count();
  json["coarse_pose"] = coarse.source;
  if (coarse.vision_from_lidar) json["initial"] = matrix_json(*coarse.vision_from_lidar);
  StageResult stage{.refused = true, .summary = {"refused: " + result.reason}};
  if (result.status == RegistrationStatus::kOk) {
    HF_TRY(
        stage,
        fuse_registered(project, companions, vision, std::move(lidar), known, result, ctx, json));
  }
  if (auto made = workspace.make_folder("registration"); !made) {
    return std::unexpected(made.error());
  }
  stage.json = to_text(json);
  if (auto written =
          write_file_atomically(workspace.path(workspace_file::kRegistration), stage.json);
      !written) {
    return std::unexpected(written.error());
  }
  return stage;
}

}  // namespace

Expected<StageOutcome> register_stage(Project& project,
                                      const RegisterInputs& inputs,
                                      const RunContext& ctx) {
  if (beside(inputs.vision, "frame.json")) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: its frame is arbitrary and its unit is no metre, because the "
                            "photos have no position; run reconstruct with --geo (positions of "
                            "photos) or --gcp (ground control points)",
                            inputs.vision.string()));
  }
  const Companions companions = companions_of(inputs);
  StagePlan plan{
      .stage = "register",
      .option_groups = {"registration", "fusion"},
      .inputs = {inputs.vision, inputs.lidar},
      .outputs = {
          workspace_file::kRegistration, workspace_file::kFusedPly, workspace_file::kFusedLas}};
  for (const auto& path : {inputs.initial,
                           companions.trajectory,
                           companions.gnss,
                           companions.level,
                           companions.origin,
                           companions.covariance}) {
    if (path) plan.inputs.push_back(*path);
  }
  plan.variant = inputs.near_identity ? "near identity" : "";
  return run_stage(
      project, plan, ctx, [&] { return register_into(project, inputs, companions, ctx); });
}

}  // namespace hybridfusion
