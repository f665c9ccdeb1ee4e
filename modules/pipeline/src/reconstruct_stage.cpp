#include "digest.hpp"
#include "finding_list.hpp"
#include "imported_poses.hpp"
#include "json_text.hpp"
#include "photo_cache_files.hpp"
#include "position_sources.hpp"
#include "reconstruct_summary.hpp"
#include "stage_runner.hpp"
#include "vision_files.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/vision/densify.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

std::vector<std::filesystem::path> photo_files(const PhotoFolder& folder) {
  std::vector<std::filesystem::path> files;
  for (const Photo& photo : folder.photos) files.push_back(folder.folder / photo.metadata.name);
  for (const QuarantinedPhoto& photo : folder.quarantined) {
    files.push_back(folder.folder / photo.name);
  }
  std::ranges::sort(files);
  return files;
}

/// Positions of the photos by all sources, and what is amiss with them without refusing the run.
struct JudgedPositions {
  PositionSources sources = {};
  std::vector<std::string> warnings = {};
};

Expected<JudgedPositions> judge_positions(const PhotoInputs& inputs,
                                          PhotoFolder& folder,
                                          const PositionLimits& limits,
                                          const RunContext& ctx) {
  JudgedPositions result;
  HF_TRY(result.sources, take_positions(inputs, folder));
  auto judged = judged_positions(result.sources, limits);
  if (!judged) {
    // What was taken for granted may be why.
    for (const auto* notes : {&result.sources.tags.notes, &result.sources.control.notes}) {
      for (const std::string& note : *notes) ctx.warn(note);
    }
    return std::unexpected(std::move(judged.error()));
  }
  result.warnings = *std::move(judged);
  if (inputs.geo_tags) {
    ctx.info(fmt::format("{}: positions of {} of {} photos",
                         inputs.geo_tags->string(),
                         result.sources.num_tagged,
                         folder.photos.size()));
  }
  const PhotoFolderNotes notes = notes_of(folder.listing);
  for (const std::string& fact : notes.facts) ctx.info(fact);
  if (!notes.left_out.empty()) {
    result.warnings.push_back(fmt::format("{} image files that are no JPEG are left out: {}",
                                          notes.left_out.size(),
                                          listed(notes.left_out)));
  }
  return result;
}

/// Where ground control puts the photos against their own positions. Only the spread of control is
/// known here, not which point is wrong, so that it is judged as one.
std::vector<PositionConflict> compare_control_result(const Reconstruction& reconstruction,
                                                     const SurveyFile& survey,
                                                     const PositionLimits& limits) {
  if (survey.points.empty() || reconstruction.control.empty()) return {};
  double sum_m = 0.0;
  for (const SurveyedPoint& point : survey.points) sum_m += point.position.altitude_m;
  return compare_placement(reconstruction,
                           {.what = "ground control",
                            .height_m = sum_m / static_cast<double>(survey.points.size()),
                            .unit_assumed = survey.metres_per_height_unit != 1.0},
                           limits);
}

/// By structure from motion, or from the given poses.
Expected<PosedPhotos> posed_photos(const Workspace& workspace,
                                   const PhotoFolder& folder,
                                   const PhotoInputs& inputs,
                                   const SurveyFile& survey,
                                   const VisionStageOptions& stage_options,
                                   const RunContext& ctx) {
  const ReconstructionOptions& options = stage_options.reconstruction;
  if (inputs.poses) {
    return import_poses(*inputs.poses, folder.photos, limits_of(stage_options));
  }
  const std::vector<ControlPoint> control = control_points(survey, folder);
  PhotoCache cache = open_photo_cache(workspace, ctx);
  if (cache.load) {
    for (const Photo& photo : folder.photos) {
      const auto sha256 = sha256_of_file(folder.folder / photo.metadata.name);
      cache.keys.push_back(sha256 ? photo_cache_key(*sha256, options) : std::string());
    }
  }
  HF_TRY(Reconstruction reconstruction, reconstruct(folder.photos, options, ctx, control, &cache));
  return PosedPhotos{.reconstruction = std::move(reconstruction), .photos = folder.photos};
}

/// Where the result lies: origin.json; frame.json instead says that it lies nowhere.
Expected<void> write_frame(const Workspace& workspace, const Reconstruction& reconstruction) {
  if (reconstruction.georeferenced) {
    return write_origin(workspace.path(workspace_file::kOrigin), reconstruction.origin);
  }
  const Json json = {{"frame", "arbitrary"},
                     {"metric", false},
                     {"reason", "the photos have no usable position and no ground control"}};
  return write_file_atomically(workspace.path(workspace_file::kFrame), to_text(json));
}

/// The files are there, but not where they should be.
void refuse_result(const std::vector<std::string>& refusals, StageResult& result) {
  if (refusals.empty()) return;
  result.refused = true;
  for (const std::string& refusal : refusals) result.summary.push_back("refused: " + refusal);
  Json json = Json::parse(result.json);
  json["contradictions"] = refusals;
  result.json = to_text(json);
}

Expected<StageResult> reconstruct_into(Project& project,
                                       const PhotoFolder& folder,
                                       const PhotoInputs& inputs,
                                       const JudgedPositions& positions,
                                       const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  const VisionStageOptions& options = project.options.vision;
  for (const QuarantinedPhoto& photo : folder.quarantined) {
    ctx.warn(fmt::format("{} is left out: {}", photo.name, photo.reason));
  }
  if (auto made = workspace.make_folder("vision"); !made) return std::unexpected(made.error());
  const SurveyFile& survey = positions.sources.control;
  HF_TRY(PosedPhotos posed, posed_photos(workspace, folder, inputs, survey, options, ctx));
  Reconstruction& reconstruction = posed.reconstruction;
  std::vector<std::string>& warnings = reconstruction.warnings;
  warnings.insert(warnings.begin(), positions.warnings.begin(), positions.warnings.end());
  std::vector<std::string> refusals;
  for (const auto& conflict : compare_control_result(reconstruction, survey, limits_of(options))) {
    (is_error(conflict) ? refusals : warnings).push_back(conflict.text);
  }
  for (const std::string& warning : reconstruction.warnings) ctx.warn(warning);
  HF_TRY(const PointCloud dense,
         densify(posed.photos, reconstruction, options.densify, ctx, workspace.path("vision")));
  const ColmapModel model = model_as_given(posed, colmap_model_of(reconstruction));
  auto written = write_colmap_model(workspace.path("vision"), model);
  if (written && options.model_format == "both") {
    written = write_colmap_binary(workspace.path("vision"), model);
  }
  if (written) {
    written = write_positions_csv(workspace.path(workspace_file::kPositions),
                                  position_rows(reconstruction, folder.quarantined));
  }
  if (written) {
    written = write_file_atomically(workspace.path(workspace_file::kPoseCovariance),
                                    covariance_csv(reconstruction));
  }
  if (written) written = write_frame(workspace, reconstruction);
  if (written) written = write_ply(workspace.path(workspace_file::kDense), dense);
  if (!written) return std::unexpected(written.error());
  remove_photo_cache(workspace);
  StageResult result = reconstruct_summary(
      reconstruction, inputs.poses ? PoseSource::kGiven : PoseSource::kAdjusted, folder, dense);
  refuse_result(refusals, result);
  return result;
}

}  // namespace

Expected<StageOutcome> reconstruct_stage(Project& project,
                                         const PhotoInputs& given,
                                         const RunContext& ctx) {
  const PhotoInputs inputs = with_files_beside(given);
  HF_TRY(PhotoFolder folder, open_photo_folder(inputs.images));
  HF_TRY(const JudgedPositions positions,
         judge_positions(inputs, folder, limits_of(project.options.vision), ctx));
  StagePlan plan{.stage = "reconstruct",
                 .option_groups = {"vision"},
                 .inputs = photo_files(folder),
                 .outputs = {workspace_file::kCameras,
                             workspace_file::kImages,
                             workspace_file::kPoints3d,
                             "vision/cameras.bin",
                             "vision/images.bin",
                             "vision/points3D.bin",
                             workspace_file::kPositions,
                             workspace_file::kOrigin,
                             workspace_file::kFrame,
                             workspace_file::kPoseCovariance,
                             workspace_file::kDense}};
  if (inputs.geo_tags) plan.inputs.push_back(*inputs.geo_tags);
  if (inputs.control) plan.inputs.push_back(*inputs.control);
  if (inputs.poses) {
    plan.variant = "given poses";
    std::ranges::copy(pose_files(*inputs.poses), std::back_inserter(plan.inputs));
  }
  return run_stage(project, plan, ctx, [&] {
    return reconstruct_into(project, folder, inputs, positions, ctx);
  });
}

}  // namespace hybridfusion
