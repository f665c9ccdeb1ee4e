#include "fuse_registered.hpp"

#include "level_correction.hpp"
#include "registration_json.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/las.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/point_cloud_file.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/registration/fuse_clouds.hpp>

#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

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
      fmt::format(
          "{} fused points, {} of them interpolated in narrow gaps (source 2); {} vision and "
          "{} LiDAR points were doubles",
          fused.cloud.size(),
          fused.interpolated,
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

}  // namespace

Expected<StageResult> fuse_registered(const Project& project,
                                      const Companions& companions,
                                      RegisteredClouds clouds,
                                      const RunContext& ctx,
                                      Json& json) {
  const FusionStageOptions& options = project.options.fusion;
  const RegistrationResult& result = clouds.result;
  HF_TRY(const FusedFrame frame, fused_frame(result, companions, options, ctx));
  HF_TRY(PointCloud lidar,
         without_drift(std::move(clouds.lidar), result.drift, clouds.sensor_positions, ctx));
  HF_TRY(const FuseResult fused,
         fuse_clouds(std::move(clouds.vision),
                     std::move(lidar),
                     frame.from_lidar,
                     frame.from_vision,
                     options.clouds,
                     ctx));
  if (auto written = write_fused(project.workspace, fused.cloud, companions.origin); !written) {
    return std::unexpected(written.error());
  }
  json["fused_from_vision"] = matrix_json(frame.from_vision);
  json["fused_from_lidar"] = matrix_json(frame.from_lidar);
  json["level"] = json_of(frame.level);
  json["num_fused_points"] = fused.cloud.size();
  json["num_interpolated_points"] = fused.interpolated;
  json["num_vision_points_dropped"] = fused.vision_dropped;
  json["num_lidar_points_dropped"] = fused.lidar_dropped;
  return StageResult{.summary = summary_of(result, fused, frame, json.value("seconds", 0.0))};
}

}  // namespace hybridfusion
