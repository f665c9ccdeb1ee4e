#include "json_text.hpp"
#include "view_layers.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/pipeline/view_scene.hpp>
#include <hybridfusion/pipeline/workspace.hpp>

#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

bool is_file(const std::filesystem::path& path) {
  std::error_code code;
  return std::filesystem::is_regular_file(path, code);
}

/// Size and time of each file that is there.
std::string key_of(const std::filesystem::path& root) {
  constexpr int kFormat = 2;  // of the cached octrees; a new one makes them anew
  std::string key = fmt::format("format {}\n", kFormat);
  for (const std::string_view name : {workspace_file::kDense,
                                      workspace_file::kMap,
                                      workspace_file::kFusedPly,
                                      workspace_file::kRegistration}) {
    std::error_code code;
    const auto size = std::filesystem::file_size(root / name, code);
    if (code) continue;
    const auto time = std::filesystem::last_write_time(root / name, code);
    key += fmt::format("{} {} {}\n", name, size, time.time_since_epoch().count());
  }
  return key;
}

Json cameras_json(const std::filesystem::path& root, const Sim3& fused_from_vision) {
  Json cameras = Json::array();
  const auto model = read_colmap_model(root / "vision");
  if (!model) return cameras;
  for (const ColmapImage& image : model->images) {
    const Rigid3 camera_from_enu{.rotation = image.camera_from_world,
                                 .translation = image.camera_from_world_translation};
    Json json = {
        {"name", image.name},
        {"world_from_camera", matrix_json(fused_from_vision.map_pose(camera_from_enu.inverse()))}};
    for (const ColmapCamera& camera : model->cameras) {
      if (camera.id != image.camera || camera.params.empty() || camera.params.front() <= 0.0) {
        continue;
      }
      json["half_width"] = 0.5 * camera.width_px / camera.params.front();
      json["half_height"] = 0.5 * camera.height_px / camera.params.front();
    }
    cameras.push_back(std::move(json));
  }
  return cameras;
}

/// Positions in the LiDAR map, at most some thousand.
Json trajectory_json(const std::filesystem::path& root) {
  constexpr std::size_t kMaxPositions = 5000;
  Json positions = Json::array();
  const auto trajectory = read_tum(root / workspace_file::kTrajectory);
  if (!trajectory) return positions;
  const std::size_t step = 1 + trajectory->poses.size() / kMaxPositions;
  for (std::size_t i = 0; i < trajectory->poses.size(); i += step) {
    const Eigen::Vector3d& p = trajectory->poses[i].map_from_body.translation;
    positions.push_back({p.x(), p.y(), p.z()});
  }
  return positions;
}

Json registration_json(const StoredRegistration& registration) {
  Json json = {{"status", registration.ok ? "ok" : "refused"},
               {"confidence", registration.confidence},
               {"method", registration.method},
               {"reason", registration.reason},
               {"has_initial", registration.initial.has_value()}};
  if (registration.ok) {
    json["before"] = matrix_json(registration.initial.value_or(Rigid3{}));
    json["after"] = matrix_json(registration.fused_from_lidar);
  }
  return json;
}

}  // namespace

Expected<ViewScene> view_scene(const std::filesystem::path& root, const RunContext& ctx) {
  ViewScene scene{.key = key_of(root)};
  std::optional<StoredRegistration> registration;
  if (is_file(root / workspace_file::kRegistration)) {
    HF_TRY(registration, read_registration(root / workspace_file::kRegistration));
  }
  const bool registered = registration && registration->ok;
  const Sim3 fused_from_vision = registered ? registration->fused_from_vision : Sim3{};
  const bool has_vision = is_file(root / workspace_file::kDense);
  const bool has_lidar = is_file(root / workspace_file::kMap);
  const bool compares = registered && has_vision && has_lidar;
  auto clouds = std::make_shared<ViewClouds>(
      has_vision ? root / workspace_file::kDense : std::filesystem::path(),
      has_lidar ? root / workspace_file::kMap : std::filesystem::path(),
      fused_from_vision,
      registered ? registration->fused_from_lidar : Rigid3{},
      ctx);
  Json layers = Json::array();
  const auto add = [&](std::string_view name, std::string_view file, ViewCloud cloud, Json pose) {
    if (!is_file(root / file)) return;
    scene.layers.push_back(
        {.name = std::string(name),
         .file = root / file,
         .batches = [clouds, path = root / file, cloud, compares](const auto& visit) {
           return clouds->visit(path, cloud, compares, visit);
         }});
    layers.push_back({{"name", name}, {"file", file}, {"world_from_layer", std::move(pose)}});
  };
  add("fused", workspace_file::kFusedPly, ViewCloud::kFused, matrix_json(Rigid3{}));
  add("vision", workspace_file::kDense, ViewCloud::kVision, matrix_json(fused_from_vision));
  add("lidar",
      workspace_file::kMap,
      ViewCloud::kLidar,
      matrix_json(registered ? registration->fused_from_lidar : Rigid3{}));
  if (scene.layers.empty()) {
    return fail(ErrorCode::kNotFound,
                fmt::format("{}: holds no cloud to show; run hybridfusion run, reconstruct, map or "
                            "register with --output {} first",
                            root.string(),
                            root.string()));
  }
  std::error_code code;
  const std::filesystem::path real = std::filesystem::weakly_canonical(root, code);
  const Json json = {{"name", real.filename().string()},
                     {"layers", layers},
                     {"max_distance_m", kMaxViewDistance_m},
                     {"registration", registration ? registration_json(*registration) : Json()},
                     {"cameras", cameras_json(root, fused_from_vision)},
                     {"trajectory_in_lidar", trajectory_json(root)},
                     {"report", is_file(root / workspace_file::kReport)}};
  scene.json = to_text(json);
  return scene;
}

}  // namespace hybridfusion
