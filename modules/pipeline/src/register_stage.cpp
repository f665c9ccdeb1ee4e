#include "coarse_pose.hpp"
#include "companion_files.hpp"
#include "fuse_registered.hpp"
#include "gnss_difference.hpp"
#include "json_text.hpp"
#include "registration_json.hpp"
#include "stage_runner.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

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

Expected<StageResult> register_into(Project& project,
                                    const RegisterInputs& inputs,
                                    const Companions& companions,
                                    const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  HF_TRY(PointCloud vision, read_point_cloud(inputs.vision));
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
  const double max_sigma = project.options.vision.max_conflict_sigma;
  RegistrationResult result{.status = RegistrationStatus::kRefused, .method = options.method};
  if (const auto apart = sites_apart(vision, lidar, coarse, max_sigma)) {
    result.reason = *apart;
  } else {
    HF_TRY(result, registered_or_refused(vision, lidar, known, options, ctx));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  Json json = registration_json(result);
  json["seconds"] = seconds.count();
  json["coarse_pose"] = coarse.source;
  if (coarse.vision_from_lidar) json["initial"] = matrix_json(*coarse.vision_from_lidar);
  StageResult stage{.refused = true, .summary = {"refused: " + result.reason}};
  if (result.status == RegistrationStatus::kOk) {
    HF_TRY(stage,
           fuse_registered(project,
                           companions,
                           {.vision = std::move(vision),
                            .lidar = std::move(lidar),
                            .sensor_positions = known.sensor_positions,
                            .result = result},
                           ctx,
                           json));
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
