#include "coarse_pose.hpp"
#include "json_text.hpp"
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
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Files of the workspaces around the two clouds that help, when they exist.
struct Companions {
  std::optional<std::filesystem::path> trajectory = {};  ///< Beside L.
  std::optional<std::filesystem::path> gnss = {};        ///< Beside L.
  std::optional<std::filesystem::path> origin = {};      ///< Beside G.
};

std::optional<std::filesystem::path> beside(const std::filesystem::path& file,
                                            std::string_view name) {
  const std::filesystem::path path = file.parent_path() / name;
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return std::nullopt;
  return path;
}

Companions companions_of(const RegisterInputs& inputs) {
  return {.trajectory = beside(inputs.lidar, "trajectory.tum"),
          .gnss = beside(inputs.lidar, "gnss.json"),
          .origin = beside(inputs.vision, "origin.json")};
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

Json json_of(const PoseCovariance& covariance) {
  Json numbers = Json::array();
  for (Eigen::Index r = 0; r < 6; ++r) {
    for (Eigen::Index c = 0; c < 6; ++c) numbers.push_back(covariance(r, c));
  }
  return numbers;
}

Json json_of(const PatchMatch& patch) {
  const auto cell = [](const Eigen::Vector2i& index) { return Json{index.x(), index.y()}; };
  return {
      {"lidar_cell", cell(patch.lidar_cell)},
      {"vision_cell", cell(patch.vision_cell)},
      {"outcome", to_string(patch.outcome)},
      {"centroid_in_vision",
       {patch.centroid_in_vision.x(), patch.centroid_in_vision.y(), patch.centroid_in_vision.z()}},
      {"num_points", patch.num_points},
      {"num_candidates", patch.num_candidates},
      {"num_correlated", patch.num_correlated},
      {"num_similar", patch.num_similar},
      {"correlation", patch.correlation},
      {"neighbour_score", patch.neighbour_score},
      {"score_2d_m", patch.score_2d_m},
      {"score_3d_m", patch.score_3d_m},
      {"vision_from_lidar", matrix_json(patch.vision_from_lidar)}};
}

Json json_of(const DriftCorrection& drift) {
  const auto vector = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  Json knots = Json::array();
  for (const DriftKnot& knot : drift.knots) {
    knots.push_back({{"at", knot.at},
                     {"pivot", vector(knot.pivot)},
                     {"shift_m", vector(knot.shift_m)},
                     {"turn_rad", vector(knot.turn_rad)}});
  }
  return {{"corrected", drift.supported},
          {"along", drift.axis == DriftAxis::kTime ? "time_s" : "path_m"},
          {"size_m", drift.size_m},
          {"held_out_before_m", drift.held_out_before_m},
          {"held_out_after_m", drift.held_out_after_m},
          {"knots", std::move(knots)}};
}

Json json_of(const RegistrationResult& result) {
  Json scores = Json::object();
  for (const RegistrationScore& score : result.scores) scores[score.name] = score.value;
  Json candidates = Json::array();
  for (const PoseCandidate& candidate : result.candidates) {
    candidates.push_back({{"vision_from_lidar", matrix_json(candidate.vision_from_lidar)},
                          {"score", candidate.score}});
  }
  Json yaw_scores = Json::array();
  for (const YawScore& yaw : result.yaw_scores) {
    yaw_scores.push_back({{"yaw_rad", yaw.yaw_rad}, {"score", yaw.score}});
  }
  Json patches = Json::array();
  for (const PatchMatch& patch : result.patches) patches.push_back(json_of(patch));
  const bool ok = result.status == RegistrationStatus::kOk;
  return {{"status", ok ? "ok" : "refused"},
          {"vision_from_lidar", ok ? matrix_json(result.vision_from_lidar) : Json()},
          {"covariance", json_of(result.covariance)},
          {"confidence", result.confidence},
          {"reason", result.reason},
          {"patches", patches},
          {"scores", scores},
          {"method", result.method},
          {"candidates", candidates},
          {"yaw_scores", yaw_scores},
          {"drift", json_of(result.drift)},
          {"vision_scale", result.vision_scale},
          {"vision_scale_sigma", result.vision_scale_sigma},
          {"vision_scale_supported", result.vision_scale_supported}};
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

/// What the user reads of an accepted registration, a line each.
std::vector<std::string> summary_of(const RegistrationResult& result,
                                    const FuseResult& fused,
                                    bool rescaled,
                                    double seconds) {
  std::vector<std::string> lines = {
      fmt::format(
          "method {}, confidence {:.2f}, {:.1f} s", result.method, result.confidence, seconds),
      result.vision_scale_supported
          ? fmt::format("photo model scale {:+.3f} % against the LiDAR cloud{}",
                        100.0 * (1.0 / result.vision_scale - 1.0),
                        rescaled ? ", corrected in the fused cloud" : "")
          : std::string("photo model scale could not be told from the LiDAR cloud"),
      fmt::format("{} fused points; {} vision and {} LiDAR points were doubles",
                  fused.cloud.size(),
                  fused.vision_dropped,
                  fused.lidar_dropped)};
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
  const Sim3 rescale = fused_from_vision(result, project.options.fusion.rescale_vision);
  Json json = json_of(result);
  json["seconds"] = seconds.count();
  json["coarse_pose"] = coarse.source;
  if (coarse.vision_from_lidar) json["initial"] = matrix_json(*coarse.vision_from_lidar);
  json["fused_from_vision"] = matrix_json(rescale);
  StageResult stage{.refused = result.status == RegistrationStatus::kRefused};
  if (stage.refused) {
    stage.summary = {"refused: " + result.reason};
  } else {
    HF_TRY(lidar, without_drift(std::move(lidar), result.drift, known.sensor_positions, ctx));
    HF_TRY(
        const FuseResult fused,
        fuse_clouds(
            vision, lidar, result.vision_from_lidar, rescale, project.options.fusion.clouds, ctx));
    if (auto written = write_fused(workspace, fused.cloud, companions.origin); !written) {
      return std::unexpected(written.error());
    }
    json["num_fused_points"] = fused.cloud.size();
    json["num_vision_points_dropped"] = fused.vision_dropped;
    json["num_lidar_points_dropped"] = fused.lidar_dropped;
    stage.summary = summary_of(result, fused, rescale.scale != 1.0, seconds.count());
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
  for (const auto& path :
       {inputs.initial, companions.trajectory, companions.gnss, companions.origin}) {
    if (path) plan.inputs.push_back(*path);
  }
  plan.variant = inputs.near_identity ? "near identity" : "";
  return run_stage(
      project, plan, ctx, [&] { return register_into(project, inputs, companions, ctx); });
}

}  // namespace hybridfusion
