#pragma once

#include "positions_csv.hpp"

#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <string>
#include <vector>

namespace hybridfusion {

/// Registered photos and scene points as a COLMAP model: identifiers count from 1 and pixels move
/// by half a pixel, because COLMAP puts the first pixel's centre at (0.5, 0.5).
[[nodiscard]] ColmapModel colmap_model_of(const Reconstruction& reconstruction);

/// One row per photo of the folder, damaged ones included, in order of name.
[[nodiscard]] std::vector<PositionRow> position_rows(
    const Reconstruction& reconstruction, const std::vector<QuarantinedPhoto>& quarantined);

/// Table with the covariance of every registered photo that has one: name, deviations of the centre
/// (east, north, up, m) and of the rotation (about the camera's x, y, z, degrees), then the 21
/// entries of the upper triangle, row by row [m, rad].
[[nodiscard]] std::string covariance_csv(const Reconstruction& reconstruction);

}  // namespace hybridfusion
