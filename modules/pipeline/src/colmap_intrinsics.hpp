#pragma once

#include <hybridfusion/io/colmap_model.hpp>
#include <hybridfusion/vision/camera.hpp>

namespace hybridfusion {

/// COLMAP puts the first pixel's centre at (0.5, 0.5), this library at (0, 0).
inline constexpr double kColmapShift_px = 0.5;

/// Intrinsics of a COLMAP camera; its pixels move by half a pixel.
/// @returns kParse naming the model for one that has no counterpart here (fisheye and the like).
[[nodiscard]] Expected<CameraIntrinsics> intrinsics_of(const ColmapCamera& camera);

}  // namespace hybridfusion
