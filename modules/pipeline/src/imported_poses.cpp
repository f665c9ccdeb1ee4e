#include "imported_poses.hpp"

#include "colmap_intrinsics.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/core/sim3.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kOriginFile = "origin.json";

/// Model positions onto measured ones: least squares, once more without the worst.
Expected<Sim3> align_to_fixes(const std::vector<Eigen::Vector3d>& target,
                              const std::vector<Eigen::Vector3d>& source) {
  HF_TRY(Sim3 first, fit_sim3(target, source));
  std::vector<double> residuals;
  for (std::size_t i = 0; i < target.size(); ++i) {
    residuals.push_back((first * source[i] - target[i]).norm());
  }
  std::vector<double> sorted = residuals;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  constexpr double kGate = 4.0;
  const double limit = kGate * sorted[sorted.size() / 2];
  std::vector<Eigen::Vector3d> kept_target;
  std::vector<Eigen::Vector3d> kept_source;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (residuals[i] > limit) continue;
    kept_target.push_back(target[i]);
    kept_source.push_back(source[i]);
  }
  auto refined = fit_sim3(kept_target, kept_source);
  return refined ? refined : Expected<Sim3>(first);
}

void apply(const Sim3& enu_from_model, Reconstruction& reconstruction) {
  for (View& view : reconstruction.views) {
    if (!view.enu_from_camera) continue;
    view.enu_from_camera = enu_from_model.map_pose(*view.enu_from_camera);
  }
  for (ScenePoint& point : reconstruction.points) {
    point.point_in_enu = enu_from_model * point.point_in_enu;
  }
}

/// Views by photo; fills view_of with the index of the view of each image of the model.
Expected<void> add_views(const ColmapModel& model,
                         std::span<const Photo> photos,
                         const std::map<std::uint32_t, std::uint32_t>& cameras,
                         Reconstruction& reconstruction,
                         std::unordered_map<std::uint32_t, std::uint32_t>& view_of) {
  std::map<std::string, const ColmapImage*> by_name;
  for (const ColmapImage& image : model.images) {
    by_name[std::filesystem::path(image.name).filename().string()] = &image;
  }
  for (const Photo& photo : photos) {
    View view = {.name = photo.metadata.name};
    const auto found = by_name.find(view.name);
    if (found == by_name.end()) {
      view.reason = "not in the given poses";
      reconstruction.views.push_back(std::move(view));
      continue;
    }
    const ColmapImage& image = *found->second;
    const auto camera = cameras.find(image.camera);
    if (camera == cameras.end()) {
      return fail(ErrorCode::kParse,
                  fmt::format("images.txt: {} names camera {}, which cameras.txt does not have; "
                              "export the model again",
                              image.name,
                              image.camera));
    }
    view.camera = camera->second;
    const CameraIntrinsics& intrinsics = reconstruction.cameras[view.camera];
    if (intrinsics.width_px != photo.metadata.width ||
        intrinsics.height_px != photo.metadata.height) {
      return fail(ErrorCode::kParse,
                  fmt::format("{} has {} x {} pixels, its camera in the given poses {} x {}; give "
                              "the photos that the poses were made from",
                              view.name,
                              photo.metadata.width,
                              photo.metadata.height,
                              intrinsics.width_px,
                              intrinsics.height_px));
    }
    const Rigid3 camera_from_world{.rotation = image.camera_from_world,
                                   .translation = image.camera_from_world_translation};
    view.enu_from_camera = camera_from_world.inverse();
    view_of[image.id] = static_cast<std::uint32_t>(reconstruction.views.size());
    reconstruction.views.push_back(std::move(view));
  }
  return {};
}

/// Scene points with those of their observations that exist.
void add_points(const ColmapModel& model,
                const std::unordered_map<std::uint32_t, std::uint32_t>& view_of,
                Reconstruction& reconstruction) {
  std::unordered_map<std::uint32_t, const ColmapImage*> images;
  for (const ColmapImage& image : model.images) images[image.id] = &image;
  for (const ColmapPoint3D& stored : model.points) {
    const auto index = static_cast<std::uint32_t>(reconstruction.points.size());
    ScenePoint point = {.point_in_enu = stored.point_in_world,
                        .color = stored.color,
                        .mean_error_px = static_cast<float>(stored.error_px)};
    for (const ColmapTrackElement& seen : stored.track) {
      const auto view = view_of.find(seen.image);
      if (view == view_of.end() || seen.point2d >= images[seen.image]->points.size()) continue;
      std::vector<Observation>& observations = reconstruction.views[view->second].observations;
      point.track.push_back(
          {.view = view->second, .observation = static_cast<std::uint32_t>(observations.size())});
      const Eigen::Vector2d pixel = images[seen.image]->points[seen.point2d].pixel;
      observations.push_back(
          {.point = index, .pixel = (pixel.array() - kColmapShift_px).cast<float>()});
    }
    reconstruction.points.push_back(std::move(point));
  }
}

std::vector<PhotoMetadata> metadata_of(std::span<const Photo> photos) {
  std::vector<PhotoMetadata> metadata;
  for (const Photo& photo : photos) metadata.push_back(photo.metadata);
  return metadata;
}

/// Puts the reconstruction into the plane of the photos' own positions.
Expected<void> place_by_photos(std::span<const Photo> photos,
                               const GnssOptions& options,
                               Reconstruction& reconstruction) {
  HF_TRY(const GnssIngest gnss, ingest_gnss(metadata_of(photos), options));
  std::vector<Eigen::Vector3d> target;
  std::vector<Eigen::Vector3d> source;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    View& view = reconstruction.views[i];
    view.gnss_in_enu = gnss.fixes[i].position_in_enu;
    if (!view.enu_from_camera || !view.gnss_in_enu) continue;
    target.push_back(*view.gnss_in_enu);
    source.push_back(view.enu_from_camera->translation);
  }
  constexpr std::size_t kMinFixes = 3;
  if (target.size() < kMinFixes) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} photos of the given poses have a position, at least {} are needed "
                            "to place the model; add origin.json if it is in metres east, north, "
                            "up already",
                            target.size(),
                            kMinFixes));
  }
  HF_TRY(const Sim3 enu_from_model, align_to_fixes(target, source));
  apply(enu_from_model, reconstruction);
  reconstruction.origin = gnss.origin;
  reconstruction.warnings = gnss.warnings;
  return {};
}

/// Notes where GNSS saw the photos of a model that has its place already.
void note_positions(std::span<const Photo> photos,
                    const GnssOptions& options,
                    Reconstruction& reconstruction) {
  const auto gnss = ingest_gnss(metadata_of(photos), options);
  if (!gnss) return;  // the photos know nothing of their place
  const Rigid3 enu_from_gnss = enu_from_enu(reconstruction.origin, gnss->origin);
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const auto& position = gnss->fixes[i].position_in_enu;
    if (position) reconstruction.views[i].gnss_in_enu = enu_from_gnss * *position;
  }
}

void measure_quality(Reconstruction& reconstruction) {
  ReconstructionQuality& quality = reconstruction.quality;
  std::vector<double> errors_px;
  for (const ScenePoint& point : reconstruction.points) errors_px.push_back(point.mean_error_px);
  for (const double error_px : errors_px) quality.mean_reprojection_px += error_px;
  if (!errors_px.empty()) {
    quality.mean_reprojection_px /= static_cast<double>(errors_px.size());
    const auto middle = errors_px.begin() + static_cast<std::ptrdiff_t>(errors_px.size() / 2);
    std::ranges::nth_element(errors_px, middle);
    quality.median_reprojection_px = *middle;
  }
  double horizontal = 0.0;
  double vertical = 0.0;
  double count = 0.0;
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera || !view.gnss_in_enu) continue;
    const Eigen::Vector3d gap = view.enu_from_camera->translation - *view.gnss_in_enu;
    horizontal += gap.head<2>().squaredNorm();
    vertical += gap.z() * gap.z();
    count += 1.0;
  }
  if (count > 0.0) {
    quality.gnss_horizontal_rms_m = std::sqrt(horizontal / count);
    quality.gnss_vertical_rms_m = std::sqrt(vertical / count);
  }
}

}  // namespace

std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = {
      folder / "cameras.txt", folder / "images.txt", folder / "points3D.txt"};
  std::error_code code;
  if (std::filesystem::exists(folder / kOriginFile, code)) files.push_back(folder / kOriginFile);
  return files;
}

Expected<Reconstruction> import_poses(const std::filesystem::path& folder,
                                      std::span<const Photo> photos,
                                      const GnssOptions& options) {
  HF_TRY(const ColmapModel model, read_colmap_model(folder));
  Reconstruction reconstruction;
  std::map<std::uint32_t, std::uint32_t> cameras;
  for (const ColmapCamera& camera : model.cameras) {
    HF_TRY(const CameraIntrinsics intrinsics, intrinsics_of(camera));
    cameras[camera.id] = static_cast<std::uint32_t>(reconstruction.cameras.size());
    reconstruction.cameras.push_back(intrinsics);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> view_of;
  auto added = add_views(model, photos, cameras, reconstruction, view_of);
  if (!added) return std::unexpected(std::move(added.error()).with_context(folder.string()));
  if (view_of.empty()) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: images.txt names none of the photos; give the poses of these "
                            "photos",
                            folder.string()));
  }
  add_points(model, view_of, reconstruction);
  std::error_code code;
  if (std::filesystem::exists(folder / kOriginFile, code)) {
    HF_TRY(reconstruction.origin, read_origin(folder / kOriginFile));
    note_positions(photos, options, reconstruction);
  } else if (auto placed = place_by_photos(photos, options, reconstruction); !placed) {
    return std::unexpected(placed.error());
  }
  reconstruction.quality.initial_focal_px =
      reconstruction.cameras.empty() ? 0.0 : reconstruction.cameras.front().focal_px;
  measure_quality(reconstruction);
  return reconstruction;
}

}  // namespace hybridfusion
