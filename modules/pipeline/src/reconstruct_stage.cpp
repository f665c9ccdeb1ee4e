#include "digest.hpp"
#include "imported_poses.hpp"
#include "json_text.hpp"
#include "photo_cache_files.hpp"
#include "reconstruct_summary.hpp"
#include "stage_runner.hpp"
#include "vision_files.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/vision/densify.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <system_error>

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

/// Positions beside the photos, as OpenDroneMap keeps them, unless others are given.
std::optional<std::filesystem::path> given_or_beside(
    const std::optional<std::filesystem::path>& given,
    const std::filesystem::path& images,
    std::string_view name) {
  if (given) return given;
  std::error_code code;
  const std::filesystem::path beside = images / name;
  if (std::filesystem::is_regular_file(beside, code)) return beside;
  return std::nullopt;
}

PhotoInputs completed(PhotoInputs inputs) {
  inputs.geo_tags = given_or_beside(inputs.geo_tags, inputs.images, "geo.txt");
  inputs.control = given_or_beside(inputs.control, inputs.images, "gcp_list.txt");
  return inputs;
}

Expected<void> take_geo_tags(const std::filesystem::path& path,
                             PhotoFolder& folder,
                             const RunContext& ctx) {
  HF_TRY(const std::vector<GeoTag> tags, read_geo_tags(path));
  const std::size_t tagged = apply_geo_tags(tags, folder.photos);
  if (tagged == 0) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: none of its {} names is a photo of {}; give file names without "
                            "folder, as they are written there",
                            path.string(),
                            tags.size(),
                            folder.folder.string()));
  }
  ctx.info(
      fmt::format("{}: positions of {} of {} photos", path.string(), tagged, folder.photos.size()));
  return {};
}

/// Surveyed points with the photos by index. A name that starts with "chk" is for checking only.
Expected<std::vector<ControlPoint>> control_points(const std::filesystem::path& path,
                                                   const PhotoFolder& folder,
                                                   const RunContext& ctx) {
  HF_TRY(const std::vector<SurveyedPoint> surveyed, read_surveyed_points(path));
  std::vector<ControlPoint> points;
  std::size_t unknown = 0;
  for (const SurveyedPoint& from : surveyed) {
    std::string start = from.name.substr(0, 3);
    std::ranges::transform(start, start.begin(), [](unsigned char c) { return std::tolower(c); });
    ControlPoint point{.name = from.name, .position = from.position, .check = start == "chk"};
    for (const SurveyedPoint::Mark& mark : from.marks) {
      const auto photo = std::ranges::find_if(
          folder.photos, [&](const Photo& p) { return p.metadata.name == mark.photo; });
      if (photo == folder.photos.end()) {
        ++unknown;
        continue;
      }
      point.marks.push_back(
          {.photo = static_cast<std::size_t>(photo - folder.photos.begin()), .pixel = mark.pixel});
    }
    points.push_back(std::move(point));
  }
  if (unknown > 0) {
    ctx.warn(fmt::format("{}: {} marks name photos that are not there", path.string(), unknown));
  }
  return points;
}

/// By structure from motion, or from the given poses.
Expected<Reconstruction> posed_photos(const Workspace& workspace,
                                      const PhotoFolder& folder,
                                      const PhotoInputs& inputs,
                                      const ReconstructionOptions& options,
                                      const RunContext& ctx) {
  if (inputs.poses) return import_poses(*inputs.poses, folder.photos, options.gnss);
  std::vector<ControlPoint> control;
  if (inputs.control) {
    HF_TRY(control, control_points(*inputs.control, folder, ctx));
  }
  PhotoCache cache = open_photo_cache(workspace, ctx);
  if (cache.load) {
    for (const Photo& photo : folder.photos) {
      const auto sha256 = sha256_of_file(folder.folder / photo.metadata.name);
      cache.keys.push_back(sha256 ? photo_cache_key(*sha256, options) : std::string());
    }
  }
  return reconstruct(folder.photos, options, ctx, control, &cache);
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

Expected<StageResult> reconstruct_into(Project& project,
                                       const PhotoFolder& folder,
                                       const PhotoInputs& inputs,
                                       const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  const VisionStageOptions& options = project.options.vision;
  for (const QuarantinedPhoto& photo : folder.quarantined) {
    ctx.warn(fmt::format("{} is left out: {}", photo.name, photo.reason));
  }
  if (auto made = workspace.make_folder("vision"); !made) return std::unexpected(made.error());
  HF_TRY(const Reconstruction reconstruction,
         posed_photos(workspace, folder, inputs, options.reconstruction, ctx));
  for (const std::string& warning : reconstruction.warnings) ctx.warn(warning);
  HF_TRY(const PointCloud dense,
         densify(folder.photos, reconstruction, options.densify, ctx, workspace.path("vision")));
  auto written = write_colmap_model(workspace.path("vision"), colmap_model_of(reconstruction));
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
  return reconstruct_summary(
      reconstruction, inputs.poses ? PoseSource::kGiven : PoseSource::kAdjusted, folder, dense);
}

}  // namespace

Expected<StageOutcome> reconstruct_stage(Project& project,
                                         const PhotoInputs& given,
                                         const RunContext& ctx) {
  const PhotoInputs inputs = completed(given);
  HF_TRY(PhotoFolder folder, open_photo_folder(inputs.images));
  StagePlan plan{.stage = "reconstruct",
                 .option_groups = {"vision"},
                 .inputs = photo_files(folder),
                 .outputs = {workspace_file::kCameras,
                             workspace_file::kImages,
                             workspace_file::kPoints3d,
                             workspace_file::kPositions,
                             workspace_file::kOrigin,
                             workspace_file::kFrame,
                             workspace_file::kPoseCovariance,
                             workspace_file::kDense}};
  if (inputs.geo_tags) {
    if (auto taken = take_geo_tags(*inputs.geo_tags, folder, ctx); !taken) {
      return std::unexpected(taken.error());
    }
    plan.inputs.push_back(*inputs.geo_tags);
  }
  if (inputs.control) plan.inputs.push_back(*inputs.control);
  if (inputs.poses) {
    plan.variant = "given poses";
    std::ranges::copy(pose_files(*inputs.poses), std::back_inserter(plan.inputs));
  }
  return run_stage(
      project, plan, ctx, [&] { return reconstruct_into(project, folder, inputs, ctx); });
}

}  // namespace hybridfusion
