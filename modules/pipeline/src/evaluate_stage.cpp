#include "comparison_files.hpp"
#include "pair_metrics.hpp"
#include "stage_runner.hpp"
#include "truth_metrics.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/io/transform_json.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <array>
#include <iterator>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::array<std::string_view, 4> kTruthFiles = {
    "dataset.json", "cameras.csv", "trajectory_imu.tum", "mesh.ply"};

std::vector<std::filesystem::path> existing_inputs(
    const Workspace& workspace, const std::optional<std::filesystem::path>& truth) {
  std::vector<std::filesystem::path> inputs;
  for (const std::string_view name : {workspace_file::kImages,
                                      workspace_file::kDense,
                                      workspace_file::kOrigin,
                                      workspace_file::kTrajectory,
                                      workspace_file::kMap,
                                      workspace_file::kGnss,
                                      workspace_file::kRegistration,
                                      workspace_file::kFusedPly}) {
    if (workspace.has(name)) inputs.push_back(workspace.path(name));
  }
  if (!truth) return inputs;
  std::error_code code;
  for (const std::string_view name : kTruthFiles) {
    if (std::filesystem::exists(*truth / name, code)) inputs.push_back(*truth / name);
  }
  if (std::filesystem::exists(*truth / "samples.ply", code)) {
    inputs.push_back(*truth / "samples.ply");
  }
  return inputs;
}

Expected<PairMetrics> workspace_pair_metrics(const Project& project,
                                             const std::optional<Rigid3>& true_pose,
                                             const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  HF_TRY(const StoredRegistration registration,
         read_registration(workspace.path(workspace_file::kRegistration)));
  if (!registration.ok) {
    PairMetrics metrics{.json = {{"registration", "refused"}}};
    metrics.summary = {"no fused cloud to measure: the registration was refused"};
    return metrics;
  }
  HF_TRY(const PointCloud vision, read_ply(workspace.path(workspace_file::kDense)));
  HF_TRY(const PointCloud lidar, read_ply(workspace.path(workspace_file::kMap)));
  const RegisteredPair pair{.vision = vision,
                            .lidar = lidar,
                            .vision_from_lidar = registration.vision_from_lidar,
                            .truth = true_pose,
                            .initial = registration.initial,
                            .method = registration.method,
                            .seconds = registration.seconds};
  if (auto written = write_comparison(workspace, pair, ctx); !written) {
    return std::unexpected(written.error());
  }
  return pair_metrics(pair, project.options, ctx);
}

Expected<StageResult> evaluate_into(Project& project,
                                    const std::optional<std::filesystem::path>& truth,
                                    const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  StageResult result;
  TruthMetrics against_truth;
  if (truth) {
    HF_TRY(against_truth, truth_metrics(workspace, *truth, project.options.evaluation, ctx));
  }
  Json json = Json::object();
  if (workspace.has(workspace_file::kRegistration) && workspace.has(workspace_file::kDense) &&
      workspace.has(workspace_file::kMap)) {
    HF_TRY(PairMetrics metrics,
           workspace_pair_metrics(project, against_truth.true_vision_from_lidar, ctx));
    json = std::move(metrics.json);
    result.summary = std::move(metrics.summary);
  }
  if (truth) json["truth"] = std::move(against_truth.json);
  std::ranges::move(against_truth.summary, std::back_inserter(result.summary));
  result.json = to_text(json);
  if (auto made = workspace.make_folder("evaluation"); !made) return std::unexpected(made.error());
  auto written = write_file_atomically(workspace.path(workspace_file::kMetrics), result.json);
  if (!written) return std::unexpected(written.error());
  return result;
}

}  // namespace

Expected<StageOutcome> evaluate_stage(Project& project,
                                      const std::optional<std::filesystem::path>& truth,
                                      const RunContext& ctx) {
  const StagePlan plan{.stage = "evaluate",
                       .option_groups = {"registration", "evaluation"},
                       .inputs = existing_inputs(project.workspace, truth),
                       .outputs = {workspace_file::kMetrics}};
  if (plan.inputs.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: holds no result to evaluate; run reconstruct, map or register on "
                            "it first",
                            project.workspace.root().string()));
  }
  return run_stage(project, plan, ctx, [&] { return evaluate_into(project, truth, ctx); });
}

Expected<StageOutcome> evaluate_pair(const CloudPair& pair,
                                     const PipelineOptions& options,
                                     const RunContext& ctx) {
  HF_TRY(const PointCloud vision, read_point_cloud(pair.vision));
  HF_TRY(const PointCloud lidar, read_point_cloud(pair.lidar));
  RegisteredPair registered{.vision = vision, .lidar = lidar};
  if (pair.transform) {
    HF_TRY(registered.vision_from_lidar, read_transform_json(*pair.transform, "vision_from_lidar"));
  }
  if (pair.truth) {
    HF_TRY(registered.truth, read_transform_json(*pair.truth, "vision_from_lidar"));
  }
  HF_TRY(PairMetrics metrics, pair_metrics(registered, options, ctx));
  if (registered.truth) {
    Json error =
        registration_error_json(*registered.truth, registered.vision_from_lidar, centroid(lidar));
    metrics.summary.push_back(fmt::format("registration: {:.3f} m at the centroid, {:.3f} deg",
                                          error["at_centroid_m"].get<double>(),
                                          error["rotation_deg"].get<double>()));
    metrics.json["truth"]["registration"] = std::move(error);
  }
  return StageOutcome{.stage = "evaluate",
                      .result_json = to_text(metrics.json),
                      .summary = std::move(metrics.summary)};
}

}  // namespace hybridfusion
