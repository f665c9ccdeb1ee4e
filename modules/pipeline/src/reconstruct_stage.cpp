#include "imported_poses.hpp"
#include "json_text.hpp"
#include "stage_runner.hpp"
#include "vision_files.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/vision/densify.hpp>
#include <hybridfusion/vision/reconstruct.hpp>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPositionedPhotos = 3;

std::vector<std::filesystem::path> photo_files(const PhotoFolder& folder) {
  std::vector<std::filesystem::path> files;
  for (const Photo& photo : folder.photos) files.push_back(folder.folder / photo.metadata.name);
  for (const QuarantinedPhoto& photo : folder.quarantined) {
    files.push_back(folder.folder / photo.name);
  }
  std::ranges::sort(files);
  return files;
}

/// Without positions there is neither scale nor place; better said before an hour of matching.
Expected<void> check_positions(const PhotoFolder& folder) {
  const auto positioned =
      static_cast<std::size_t>(std::ranges::count_if(folder.photos, [](const Photo& photo) {
        return photo.metadata.latitude_deg && photo.metadata.longitude_deg;
      }));
  if (positioned >= kMinPositionedPhotos) return {};
  return fail(
      ErrorCode::kInsufficient,
      fmt::format("{}: {} of {} photos have a GNSS position in their EXIF data, at least {} "
                  "are needed for scale and place; use the original files of the camera",
                  folder.folder.string(),
                  positioned,
                  folder.photos.size(),
                  kMinPositionedPhotos));
}

StageResult describe(const Reconstruction& reconstruction,
                     const PhotoFolder& folder,
                     const PointCloud& dense) {
  const auto registered = std::ranges::count_if(
      reconstruction.views, [](const View& view) { return view.enu_from_camera.has_value(); });
  const ReconstructionQuality& quality = reconstruction.quality;
  const double focal_px =
      reconstruction.cameras.empty() ? 0.0 : reconstruction.cameras.front().focal_px;
  const double focal_change =
      quality.initial_focal_px > 0.0 ? focal_px / quality.initial_focal_px - 1.0 : 0.0;
  Json rejected = Json::array();
  for (const PositionRow& row : position_rows(reconstruction, folder.quarantined)) {
    if (!row.position) rejected.push_back(row.name + ": " + row.reason);
  }
  const Json json = {{"num_photos", reconstruction.views.size() + folder.quarantined.size()},
                     {"num_registered", registered},
                     {"num_quarantined", folder.quarantined.size()},
                     {"not_registered", rejected},
                     {"num_scene_points", reconstruction.points.size()},
                     {"num_dense_points", dense.size()},
                     {"mean_reprojection_px", quality.mean_reprojection_px},
                     {"median_reprojection_px", quality.median_reprojection_px},
                     {"initial_focal_px", quality.initial_focal_px},
                     {"focal_px", focal_px},
                     {"focal_change", focal_change},
                     {"gnss_horizontal_rms_m", quality.gnss_horizontal_rms_m},
                     {"gnss_vertical_rms_m", quality.gnss_vertical_rms_m},
                     {"gnss_sigma_horizontal_m", quality.estimated_sigma_horizontal_m},
                     {"gnss_sigma_vertical_m", quality.estimated_sigma_vertical_m},
                     {"scale_sigma", quality.scale_sigma},
                     {"warnings", reconstruction.warnings}};
  StageResult result{.json = to_text(json)};
  result.summary = {
      fmt::format("{} of {} photos registered, {} damaged",
                  registered,
                  reconstruction.views.size() + folder.quarantined.size(),
                  folder.quarantined.size()),
      fmt::format("reprojection {:.2f} px, focal length {:+.2f} % against its first value",
                  quality.mean_reprojection_px,
                  100.0 * focal_change),
      fmt::format("GNSS residuals {:.2f} m horizontal, {:.2f} m vertical (rms)",
                  quality.gnss_horizontal_rms_m,
                  quality.gnss_vertical_rms_m),
      fmt::format("{} scene points, {} dense points", reconstruction.points.size(), dense.size())};
  return result;
}

using PosesFolder = std::optional<std::filesystem::path>;

/// By structure from motion, or from the given poses.
Expected<Reconstruction> posed_photos(const PhotoFolder& folder,
                                      const PosesFolder& poses,
                                      const ReconstructionOptions& options,
                                      const RunContext& ctx) {
  if (poses) return import_poses(*poses, folder.photos, options.gnss);
  if (auto enough = check_positions(folder); !enough) return std::unexpected(enough.error());
  return reconstruct(folder.photos, options, ctx);
}

Expected<StageResult> reconstruct_into(Project& project,
                                       const PhotoFolder& folder,
                                       const PosesFolder& poses,
                                       const RunContext& ctx) {
  const Workspace& workspace = project.workspace;
  const VisionStageOptions& options = project.options.vision;
  for (const QuarantinedPhoto& photo : folder.quarantined) {
    ctx.warn(fmt::format("{} is left out: {}", photo.name, photo.reason));
  }
  if (auto made = workspace.make_folder("vision"); !made) return std::unexpected(made.error());
  HF_TRY(const Reconstruction reconstruction,
         posed_photos(folder, poses, options.reconstruction, ctx));
  for (const std::string& warning : reconstruction.warnings) ctx.warn(warning);
  HF_TRY(const PointCloud dense,
         densify(folder.photos, reconstruction, options.densify, ctx, workspace.path("vision")));
  auto written = write_colmap_model(workspace.path("vision"), colmap_model_of(reconstruction));
  if (written) {
    written = write_positions_csv(workspace.path(workspace_file::kPositions),
                                  position_rows(reconstruction, folder.quarantined));
  }
  if (written) {
    written = write_origin(workspace.path(workspace_file::kOrigin), reconstruction.origin);
  }
  if (written) written = write_ply(workspace.path(workspace_file::kDense), dense);
  if (!written) return std::unexpected(written.error());
  return describe(reconstruction, folder, dense);
}

}  // namespace

Expected<StageOutcome> reconstruct_stage(Project& project,
                                         const std::filesystem::path& images,
                                         const RunContext& ctx,
                                         const std::optional<std::filesystem::path>& poses) {
  HF_TRY(const PhotoFolder folder, open_photo_folder(images));
  StagePlan plan{.stage = "reconstruct",
                 .option_groups = {"vision"},
                 .inputs = photo_files(folder),
                 .outputs = {workspace_file::kCameras,
                             workspace_file::kImages,
                             workspace_file::kPoints3d,
                             workspace_file::kPositions,
                             workspace_file::kOrigin,
                             workspace_file::kDense}};
  if (poses) {
    plan.variant = "given poses";
    std::ranges::copy(pose_files(*poses), std::back_inserter(plan.inputs));
  }
  return run_stage(
      project, plan, ctx, [&] { return reconstruct_into(project, folder, poses, ctx); });
}

}  // namespace hybridfusion
