#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <filesystem>
#include <span>
#include <vector>

namespace hybridfusion {

/// Cameras, poses and scene points of a COLMAP text model for these photos, which are found by
/// their file names. With origin.json beside the model its world is the east-north-up plane there
/// (as in a workspace's vision/); without, the model is moved, turned and scaled onto the GNSS
/// positions of the photos.
/// @returns One view per photo, in their order. kParse for a damaged or contradictory model,
/// kInvalidOptions for a camera model that has no counterpart here, kInsufficient when fewer than
/// three photos of the model have a position and the model has no origin.
[[nodiscard]] Expected<Reconstruction> import_poses(const std::filesystem::path& folder,
                                                    std::span<const Photo> photos,
                                                    const GnssOptions& options);

/// The files of the model that are read.
[[nodiscard]] std::vector<std::filesystem::path> pose_files(const std::filesystem::path& folder);

}  // namespace hybridfusion
