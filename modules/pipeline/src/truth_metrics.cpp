#include "truth_metrics.hpp"

#include "truth_alignments.hpp"
#include "truth_json.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/evaluation/pose_error.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>
#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/tum.hpp>

#include <optional>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMaxScenePoints = 200000;

/// What the workspace and the truth have in common, gathered step by step.
class TruthComparison {
 public:
  TruthComparison(const Workspace& workspace,
                  std::filesystem::path truth,
                  const EvaluationOptions& options,
                  const RunContext& ctx)
      : workspace_(workspace), truth_(std::move(truth)), options_(options), ctx_(ctx) {}

  Expected<TruthMetrics> run() {
    if (auto step = load_origin(); !step) return std::unexpected(step.error());
    if (auto step = compare_cameras(); !step) return std::unexpected(step.error());
    if (auto step = compare_trajectory(); !step) return std::unexpected(step.error());
    if (auto step = compare_registration(); !step) return std::unexpected(step.error());
    if (has_truth("mesh.ply") || has_truth("samples.ply")) {
      if (auto step = compare_clouds(workspace_, truth_, known_, options_, ctx_, metrics_); !step) {
        return std::unexpected(step.error());
      }
    }
    if (metrics_.json.empty()) {
      return fail(ErrorCode::kNotFound,
                  fmt::format("{}: holds no truth for what is in {}; expected dataset.json with "
                              "cameras.csv, trajectory_imu.tum, mesh.ply or samples.ply",
                              truth_.string(),
                              workspace_.root().string()));
    }
    return std::move(metrics_);
  }

 private:
  [[nodiscard]] bool has_truth(std::string_view name) const {
    std::error_code code;
    return std::filesystem::is_regular_file(truth_ / name, code);
  }

  Expected<void> load_origin() {
    if (has_truth("dataset.json")) {
      HF_TRY(const DatasetTruth dataset, read_dataset_truth(truth_ / "dataset.json"));
      if (workspace_.has(workspace_file::kOrigin)) {
        HF_TRY(const GeodeticOrigin origin, read_origin(workspace_.path(workspace_file::kOrigin)));
        known_.truth_from_vision_absolute = enu_from_enu(dataset.origin, origin);
      }
      if (workspace_.has(workspace_file::kGnss)) {
        HF_TRY(const MapGeoreference gnss,
               read_map_georeference(workspace_.path(workspace_file::kGnss)));
        known_.truth_from_map_absolute =
            enu_from_enu(dataset.origin, gnss.origin) * gnss.enu_from_map;
      }
    }
    return {};
  }

  Expected<void> compare_cameras() {
    if (!has_truth("cameras.csv") || !workspace_.has(workspace_file::kImages)) return {};
    HF_TRY(const auto true_poses, read_true_photo_poses(truth_ / "cameras.csv"));
    HF_TRY(const auto poses, read_camera_poses(workspace_.path("vision")));
    const Rigid3 truth_from_enu = known_.truth_from_vision_absolute.value_or(Rigid3{});
    std::vector<Rigid3> truth;
    std::vector<Rigid3> estimate;
    for (const TruePhotoPose& photo : true_poses) {
      const auto pose = poses.find(photo.name);
      if (pose == poses.end()) continue;
      truth.push_back(photo.enu_from_camera);
      estimate.push_back(truth_from_enu * pose->second);
    }
    auto errors = camera_errors(truth, estimate);
    if (!errors) {
      ctx_.warn("camera errors are not available: " + errors.error().message);
      return {};
    }
    // The errors were taken in the true origin's plane; the clouds are in the estimated one's.
    const Sim3 shift{.rotation = truth_from_enu.rotation,
                     .translation = truth_from_enu.translation};
    known_.truth_from_vision = errors->truth_from_estimate * shift;
    known_.truth_from_vision_rigid = errors->truth_from_estimate_rigid * truth_from_enu;
    metrics_.json["cameras"] = json_of(*errors);
    metrics_.json["cameras"]["num_true_cameras"] = true_poses.size();
    metrics_.summary.push_back(
        fmt::format("cameras: {} of {}, centres {:.3f} m rigid, {:.3f} m similarity, {:.2f} m "
                    "absolute; scale {:+.3f} %, rotation {:.3f} deg",
                    truth.size(),
                    true_poses.size(),
                    errors->rigid_rmse_m,
                    errors->similarity_rmse_m,
                    errors->absolute_rmse_m,
                    100.0 * errors->scale_error,
                    errors->rotation_median_deg));
    return {};
  }

  Expected<void> compare_trajectory() {
    if (!has_truth("trajectory_imu.tum") || !workspace_.has(workspace_file::kTrajectory)) return {};
    HF_TRY(true_trajectory_, read_tum(truth_ / "trajectory_imu.tum"));
    HF_TRY(trajectory_, read_tum(workspace_.path(workspace_file::kTrajectory)));
    auto errors = trajectory_errors(true_trajectory_, trajectory_);
    if (!errors) {
      ctx_.warn("trajectory errors are not available: " + errors.error().message);
      return {};
    }
    known_.truth_from_map = errors->truth_from_map;
    metrics_.json["trajectory"] = json_of(*errors);
    metrics_.summary.push_back(fmt::format(
        "trajectory: ATE {:.3f} m over {:.0f} m, RPE {:.3f} m per s, {:.3f} m per 50 m; "
        "scale {:+.3f} %, tilt {:.3f} deg",
        errors->ate_rmse_m,
        errors->path_m,
        errors->over_1_s.translation_rmse_m,
        errors->over_50_m.translation_rmse_m,
        100.0 * errors->scale_error,
        errors->tilt_deg));
    return {};
  }

  Expected<void> compare_registration() {
    if (!known_.truth_from_vision || !known_.truth_from_map ||
        !workspace_.has(workspace_file::kMap)) {
      return {};
    }
    HF_TRY(const PointCloud map, read_ply(workspace_.path(workspace_file::kMap)));
    HF_TRY(const ScenePlaces places,
           true_places({map, trajectory_, true_trajectory_, *known_.truth_from_map},
                       options_.drive_radius_m,
                       kMaxScenePoints));
    HF_TRY(const SceneTruth truth, registration_truth(places, *known_.truth_from_vision));
    metrics_.true_vision_from_lidar = truth.vision_from_lidar;
    Json json = {
        {"num_points", truth.num_points},
        {"floor_rmse_m", truth.floor_rmse_m},
        {"scale_error_before", truth.scale_error},
        {"true_vision_from_lidar", matrix_json(truth.vision_from_lidar)},
        {"centroid_in_lidar",
         {truth.centroid_in_lidar.x(), truth.centroid_in_lidar.y(), truth.centroid_in_lidar.z()}}};
    add_georeference_errors(known_, truth, metrics_);
    if (workspace_.has(workspace_file::kRegistration)) {
      HF_TRY(const StoredRegistration registration,
             read_registration(workspace_.path(workspace_file::kRegistration)));
      add_registration(registration, places, truth, json);
    }
    metrics_.json["registration"] = std::move(json);
    return {};
  }

  void add_registration(const StoredRegistration& registration,
                        const ScenePlaces& places,
                        const SceneTruth& truth,
                        Json& json) {
    json["status"] = registration.ok ? "ok" : "refused";
    if (!registration.ok) {
      metrics_.summary.push_back("registration: refused, " + registration.reason);
      return;
    }
    known_.fused_from_vision = registration.fused_from_vision;
    json.update(registration_error_json(
        truth.vision_from_lidar, registration.vision_from_lidar, truth.centroid_in_lidar));
    const auto after =
        registration_truth(places, *known_.truth_from_vision * known_.fused_from_vision->inverse());
    if (after) json["scale_error_after"] = after->scale_error;
    add_fused_georeference(known_, truth, metrics_);
    const RegistrationErrors errors = registration_errors(
        truth.vision_from_lidar, registration.vision_from_lidar, truth.centroid_in_lidar);
    metrics_.summary.push_back(fmt::format(
        "registration: {:.3f} m at the centroid ({:.3f} m horizontal, {:+.3f} m "
        "vertical), {:.3f} deg; floor {:.3f} m, scale {:+.3f} % before, {:+.3f} % after",
        errors.at_centroid_m,
        errors.horizontal_m,
        errors.vertical_m,
        errors.rotation_deg,
        truth.floor_rmse_m,
        100.0 * truth.scale_error,
        100.0 * (after ? after->scale_error : truth.scale_error)));
  }

  const Workspace& workspace_;
  std::filesystem::path truth_;
  const EvaluationOptions& options_;
  const RunContext& ctx_;
  TruthMetrics metrics_ = {};
  TruthAlignments known_ = {};
  Trajectory true_trajectory_ = {};
  Trajectory trajectory_ = {};
};

}  // namespace

Expected<TruthMetrics> truth_metrics(const Workspace& workspace,
                                     const std::filesystem::path& truth_folder,
                                     const EvaluationOptions& options,
                                     const RunContext& ctx) {
  return TruthComparison(workspace, truth_folder, options, ctx).run();
}

Json registration_error_json(const Rigid3& truth,
                             const Rigid3& estimate,
                             const Eigen::Vector3d& centroid_in_lidar) {
  const RegistrationErrors errors = registration_errors(truth, estimate, centroid_in_lidar);
  return {{"at_centroid_m", errors.at_centroid_m},
          {"horizontal_m", errors.horizontal_m},
          {"vertical_m", errors.vertical_m},
          {"rotation_deg", errors.rotation_deg},
          {"success", errors.success()},
          {"precise", errors.precise()}};
}

}  // namespace hybridfusion
