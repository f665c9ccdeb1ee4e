#include "truth_metrics.hpp"

#include "cloud_truth.hpp"
#include "truth_json.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/evaluation/pose_error.hpp>
#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/evaluation/trajectory_error.hpp>
#include <hybridfusion/io/dataset_truth.hpp>
#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/tum.hpp>

#include <cmath>
#include <numbers>
#include <optional>

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
    if (auto step = compare_clouds(); !step) return std::unexpected(step.error());
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
        truth_from_vision_absolute_ = enu_from_enu(dataset.origin, origin);
      }
      if (workspace_.has(workspace_file::kGnss)) {
        HF_TRY(const MapGeoreference gnss,
               read_map_georeference(workspace_.path(workspace_file::kGnss)));
        truth_from_map_absolute_ = enu_from_enu(dataset.origin, gnss.origin) * gnss.enu_from_map;
      }
    }
    return {};
  }

  Expected<void> compare_cameras() {
    if (!has_truth("cameras.csv") || !workspace_.has(workspace_file::kImages)) return {};
    HF_TRY(const auto true_poses, read_true_photo_poses(truth_ / "cameras.csv"));
    HF_TRY(const auto poses, read_camera_poses(workspace_.path("vision")));
    const Rigid3 truth_from_enu = truth_from_vision_absolute_.value_or(Rigid3{});
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
    truth_from_vision_ = errors->truth_from_estimate * shift;
    truth_from_vision_rigid_ = errors->truth_from_estimate_rigid * truth_from_enu;
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
    truth_from_map_ = errors->truth_from_map;
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
    if (!truth_from_vision_ || !truth_from_map_ || !workspace_.has(workspace_file::kMap)) return {};
    HF_TRY(const PointCloud map, read_ply(workspace_.path(workspace_file::kMap)));
    HF_TRY(const ScenePlaces places,
           true_places({map, trajectory_, true_trajectory_, *truth_from_map_},
                       options_.drive_radius_m,
                       kMaxScenePoints));
    HF_TRY(const SceneTruth truth, registration_truth(places, *truth_from_vision_));
    metrics_.true_vision_from_lidar = truth.vision_from_lidar;
    Json json = {
        {"num_points", truth.num_points},
        {"floor_rmse_m", truth.floor_rmse_m},
        {"scale_error_before", truth.scale_error},
        {"true_vision_from_lidar", matrix_json(truth.vision_from_lidar)},
        {"centroid_in_lidar",
         {truth.centroid_in_lidar.x(), truth.centroid_in_lidar.y(), truth.centroid_in_lidar.z()}}};
    add_georeference_errors(truth);
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
    fused_from_vision_ = registration.fused_from_vision;
    json.update(registration_error_json(
        truth.vision_from_lidar, registration.vision_from_lidar, truth.centroid_in_lidar));
    const auto after =
        registration_truth(places, *truth_from_vision_ * fused_from_vision_->inverse());
    if (after) json["scale_error_after"] = after->scale_error;
    add_fused_georeference(truth);
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

  /// The same of the fused cloud, whose vertical may be gravity's.
  void add_fused_georeference(const SceneTruth& truth) {
    if (!truth_from_vision_absolute_) return;
    const Eigen::Vector3d in_vision = truth.vision_from_lidar * truth.centroid_in_lidar;
    const Eigen::Vector3d error = *truth_from_vision_absolute_ * (*fused_from_vision_ * in_vision) -
                                  *truth_from_vision_ * in_vision;
    const Sim3 truth_from_fused = *truth_from_vision_ * fused_from_vision_->inverse();
    const Eigen::Vector3d up = truth_from_fused.rotation.conjugate() *
                               truth_from_vision_absolute_->rotation * Eigen::Vector3d::UnitZ();
    const double tilt_deg = 180.0 / std::numbers::pi * std::atan2(up.head<2>().norm(), up.z());
    metrics_.json["georeference"]["fused"] = {{"horizontal_m", error.head<2>().norm()},
                                              {"vertical_m", error.z()},
                                              {"tilt_deg", tilt_deg}};
    metrics_.summary.push_back(
        fmt::format("fused cloud: {:.2f} m horizontal and {:+.2f} m vertical from its true place, "
                    "tilted by {:.3f} deg",
                    error.head<2>().norm(),
                    error.z(),
                    tilt_deg));
  }

  /// Where the georeference puts the centre of the scene, against where it is.
  void add_georeference_errors(const SceneTruth& truth) {
    const auto add = [&](std::string_view name, const Eigen::Vector3d& error) {
      metrics_.json["georeference"][std::string(name)] = {{"horizontal_m", error.head<2>().norm()},
                                                          {"vertical_m", error.z()}};
    };
    const Eigen::Vector3d at_vision = truth.vision_from_lidar * truth.centroid_in_lidar;
    if (truth_from_vision_absolute_) {
      add("vision", *truth_from_vision_absolute_ * at_vision - *truth_from_vision_ * at_vision);
    }
    if (truth_from_map_absolute_) {
      add("lidar",
          *truth_from_map_absolute_ * truth.centroid_in_lidar -
              *truth_from_map_ * truth.centroid_in_lidar);
    }
  }

  Expected<void> compare_clouds() {
    if (!has_truth("mesh.ply") && !has_truth("samples.ply")) return {};
    HF_TRY(const CloudTruth truth, load_cloud_truth(truth_));
    const auto sim = [](const Rigid3& rigid) {
      return Sim3{.rotation = rigid.rotation, .translation = rigid.translation};
    };
    const auto compare = [&](std::string_view name,
                             std::string_view file,
                             SampleView view,
                             const std::vector<CloudAlignment>& alignments) -> Expected<void> {
      if (!workspace_.has(file) || alignments.empty()) return {};
      HF_TRY(const PointCloud cloud, read_ply(workspace_.path(file)));
      HF_TRY(Json json, cloud_truth_json(cloud, truth, view, alignments, options_, ctx_));
      metrics_.summary.push_back(cloud_truth_line(name, json));
      metrics_.json["clouds"][std::string(name)] = std::move(json);
      return {};
    };
    std::vector<CloudAlignment> vision;
    std::vector<CloudAlignment> fused;
    const Sim3 vision_from_fused = fused_from_vision_.value_or(Sim3{}).inverse();
    const auto add = [&](std::string_view name, const Sim3& truth_from_vision) {
      vision.push_back({name, truth_from_vision});
      fused.push_back({name, truth_from_vision * vision_from_fused});
    };
    if (truth_from_vision_) add("similarity", *truth_from_vision_);
    if (truth_from_vision_rigid_) {
      vision.push_back({"rigid", sim(*truth_from_vision_rigid_)});
    }
    if (truth_from_vision_absolute_) {
      vision.push_back({"absolute", sim(*truth_from_vision_absolute_)});
      fused.push_back({"absolute", sim(*truth_from_vision_absolute_)});
    }
    std::vector<CloudAlignment> lidar;
    if (truth_from_map_) lidar.push_back({"rigid", sim(*truth_from_map_)});
    if (truth_from_map_absolute_) lidar.push_back({"absolute", sim(*truth_from_map_absolute_)});
    if (auto step = compare("vision", workspace_file::kDense, SampleView::kDrone, vision); !step) {
      return step;
    }
    if (auto step = compare("lidar", workspace_file::kMap, SampleView::kVehicle, lidar); !step) {
      return step;
    }
    return compare("fused", workspace_file::kFusedPly, SampleView::kEither, fused);
  }

  const Workspace& workspace_;
  std::filesystem::path truth_;
  const EvaluationOptions& options_;
  const RunContext& ctx_;
  TruthMetrics metrics_ = {};
  std::optional<Rigid3> truth_from_vision_absolute_ = {};
  std::optional<Rigid3> truth_from_map_absolute_ = {};
  std::optional<Sim3> truth_from_vision_ = {};
  std::optional<Rigid3> truth_from_vision_rigid_ = {};
  std::optional<Rigid3> truth_from_map_ = {};
  std::optional<Sim3> fused_from_vision_ = {};
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
