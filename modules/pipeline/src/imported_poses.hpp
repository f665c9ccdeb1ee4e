#pragma once

#include "given_camera.hpp"
#include "position_conflicts.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <filesystem>
#include <map>
#include <span>
#include <vector>

namespace hybridfusion {

/// Cameras, poses and scene points of a COLMAP model for these photos, which are found by their
/// names (PhotoNames). With origin.json beside the model its world is the east-north-up plane there
/// (as in a workspace's vision/); without, the model is moved, turned and scaled onto the GNSS
/// positions of the photos.
/// @returns One view per photo, in their order. kParse for a damaged or contradictory model, or a
/// camera model that has no counterpart here; kInsufficient when fewer than three photos of the
/// model have a position and the model has no origin, when it has no points, and when the place of
/// the model contradicts the positions of the photos.
struct PosedPhotos {
  Reconstruction reconstruction = {};
  /// The photos as the cameras of the reconstruction took them: those whose lens has no counterpart
  /// there (two focal lengths, rational distortion) are undistorted when they are loaded.
  std::vector<Photo> photos = {};
  /// Of the undistorted photos: the camera as given, by index into the cameras.
  std::map<std::uint32_t, GivenCamera> given = {};
};
[[nodiscard]] Expected<PosedPhotos> import_poses(const std::filesystem::path& folder,
                                                 std::span<const Photo> photos,
                                                 const PositionLimits& limits);

/// The model with the cameras and pixels of the undistorted photos as they were given.
[[nodiscard]] ColmapModel model_as_given(const PosedPhotos& poses, ColmapModel model);

/// The files of the model that are read.
[[nodiscard]] std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder);

}  // namespace hybridfusion
