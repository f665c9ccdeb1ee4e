#include "imported_poses.hpp"

#include "colmap_intrinsics.hpp"
#include "imported_place.hpp"
#include "position_conflicts.hpp"
#include "workspace_data.hpp"

#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kOriginFile = "origin.json";

/// The image of the model for each photo; nullptr where it has none.
Expected<std::vector<const ColmapImage*>> images_of(const ColmapModel& model,
                                                    std::span<const Photo> photos) {
  std::vector<std::string> names;
  for (const Photo& photo : photos) names.push_back(photo.metadata.name);
  const PhotoNames index(names);
  std::vector<const ColmapImage*> images(photos.size(), nullptr);
  for (const ColmapImage& image : model.images) {
    const auto photo = index.find(image.name);
    if (!photo) continue;
    if (images[*photo] != nullptr) {
      return fail(ErrorCode::kParse,
                  fmt::format("{} and {} of the model are both the photo {}; give the folder above "
                              "the folders that the model names",
                              images[*photo]->name,
                              image.name,
                              names[*photo]));
    }
    images[*photo] = &image;
  }
  return images;
}

/// Views by photo; fills view_of with the index of the view of each image of the model.
Expected<void> add_views(const ColmapModel& model,
                         std::span<const Photo> photos,
                         const std::map<std::uint32_t, std::uint32_t>& cameras,
                         Reconstruction& reconstruction,
                         std::unordered_map<std::uint32_t, std::uint32_t>& view_of) {
  HF_TRY(const std::vector<const ColmapImage*> image_of, images_of(model, photos));
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const Photo& photo = photos[i];
    View view = {.name = photo.metadata.name};
    if (image_of[i] == nullptr) {
      view.reason = "not in the given poses";
      reconstruction.views.push_back(std::move(view));
      continue;
    }
    const ColmapImage& image = *image_of[i];
    const auto camera = cameras.find(image.camera);
    if (camera == cameras.end()) {
      return fail(ErrorCode::kParse,
                  fmt::format("{} is of camera {}, which the model does not have; export it again",
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

/// Photos, and their observations, of cameras whose lens the reconstruction cannot hold.
void undistort(PosedPhotos& imported) {
  for (std::size_t i = 0; i < imported.photos.size(); ++i) {
    View& view = imported.reconstruction.views[i];
    const auto given = imported.given.find(view.camera);
    if (!view.enu_from_camera || given == imported.given.end()) continue;
    const GivenCamera& camera = given->second;
    const CameraIntrinsics& target = imported.reconstruction.cameras[view.camera];
    for (Observation& observation : view.observations) {
      const Eigen::Vector2d normalized = camera.normalized_of(observation.pixel.cast<double>());
      observation.pixel = project(target, normalized.homogeneous()).cast<float>();
    }
    imported.photos[i].load =
        [load = imported.photos[i].load, camera, target]() -> Expected<Image8> {
      HF_TRY(const Image8 photo, load());
      return undistorted_image(photo, camera, target);
    };
  }
}

}  // namespace

std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = colmap_files(folder);
  std::error_code code;
  if (std::filesystem::exists(folder / kOriginFile, code)) files.push_back(folder / kOriginFile);
  return files;
}

ColmapModel model_as_given(const PosedPhotos& poses, ColmapModel model) {
  for (const auto& [index, camera] : poses.given) {
    const CameraIntrinsics& undistorted = poses.reconstruction.cameras[index];
    ColmapCamera& stored = model.cameras[index];
    const auto& k = camera.k;
    stored.model = "FULL_OPENCV";
    stored.params = {camera.focal_px.x(),
                     camera.focal_px.y(),
                     camera.principal_point_px.x() + kColmapShift_px,
                     camera.principal_point_px.y() + kColmapShift_px};
    stored.params.insert(stored.params.end(),
                         {k[0], k[1], camera.p[0], camera.p[1], k[2], k[3], k[4], k[5]});
    for (ColmapImage& image : model.images) {
      if (image.camera != stored.id) continue;
      for (ColmapPoint2D& point : image.points) {
        const Eigen::Vector2d pixel = point.pixel.array() - kColmapShift_px;
        point.pixel = camera.pixel_of(unproject(undistorted, pixel)).array() + kColmapShift_px;
      }
    }
  }
  return model;
}

Expected<PosedPhotos> import_poses(const std::filesystem::path& folder,
                                   std::span<const Photo> photos,
                                   const PositionLimits& limits) {
  HF_TRY(const ColmapModel model, read_colmap_model(folder));
  PosedPhotos imported{.photos = {photos.begin(), photos.end()}};
  Reconstruction& reconstruction = imported.reconstruction;
  std::map<std::uint32_t, std::uint32_t> cameras;
  for (const ColmapCamera& camera : model.cameras) {
    const auto index = static_cast<std::uint32_t>(reconstruction.cameras.size());
    auto intrinsics = intrinsics_of(camera);
    if (!intrinsics) {
      const auto given = given_camera(camera);
      if (!given) {
        return std::unexpected(std::move(intrinsics.error()).with_context(folder.string()));
      }
      imported.given[index] = *given;
      intrinsics = undistorted_intrinsics(*given);
    }
    cameras[camera.id] = index;
    reconstruction.cameras.push_back(*intrinsics);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> view_of;
  auto added = add_views(model, photos, cameras, reconstruction, view_of);
  if (!added) return std::unexpected(std::move(added.error()).with_context(folder.string()));
  if (view_of.empty() && model.images.empty()) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: the model holds no images; export it again, as a binary model "
                            "(cameras.bin, images.bin, points3D.bin) or as a text model",
                            colmap_files(folder)[1].string()));
  }
  if (view_of.empty()) {
    return fail(
        ErrorCode::kParse,
        fmt::format(
            "{}: none of its {} images is one of the photos, the first is {}; give the poses of "
            "these photos",
            colmap_files(folder)[1].string(),
            model.images.size(),
            model.images[0].name));
  }
  add_points(model, view_of, reconstruction);
  undistort(imported);
  if (reconstruction.points.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{}: it holds no points, which tell the dense matching how far the "
                            "scene is; export them too, or make them with colmap "
                            "point_triangulator",
                            colmap_files(folder)[2].string()));
  }
  std::error_code code;
  std::string placed_by = folder.string() + ", fitted to all photos as well as it can be,";
  if (std::filesystem::exists(folder / kOriginFile, code)) {
    HF_TRY(reconstruction.origin, read_origin(folder / kOriginFile));
    note_positions(photos, limits.gnss, reconstruction);
    placed_by = (folder / kOriginFile).string();
  } else if (auto placed = place_by_photos(photos, limits.gnss, reconstruction); !placed) {
    return std::unexpected(placed.error());
  }
  if (auto judged = judge_place(placed_by, limits, reconstruction); !judged) {
    return std::unexpected(judged.error());
  }
  reconstruction.quality.initial_focal_px =
      reconstruction.cameras.empty() ? 0.0 : reconstruction.cameras.front().focal_px;
  measure_quality(reconstruction);
  return imported;
}

}  // namespace hybridfusion
