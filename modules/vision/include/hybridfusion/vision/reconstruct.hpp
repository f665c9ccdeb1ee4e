#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <span>

namespace hybridfusion {

/// Camera poses, calibration and sparse points from photos with GNSS (HybridFusion III-A.1):
/// features, matching, incremental structure from motion, similarity to the east-north-up frame,
/// bundle adjustment of reprojection and GNSS errors. The result does not depend on the number of
/// threads. Photos that could not be registered carry a reason.
/// Without usable positions the result has an arbitrary frame and says so (`georeferenced`).
/// @param photos   At least 3; pixels are loaded once, a few photos at a time.
/// @param control  Surveyed points; three or more take the place of GNSS in the adjustment.
/// @param cache    Of these photos, in this order; null: everything is computed.
/// @returns kInsufficient without enough matching photos or control, kDegenerate when the GNSS
///          track does not determine scale and orientation or control contradicts itself,
///          kCancelled, or the error of a photo when none can be loaded.
[[nodiscard]] Expected<Reconstruction> reconstruct(std::span<const Photo> photos,
                                                   const ReconstructionOptions& options,
                                                   const RunContext& ctx = {},
                                                   std::span<const ControlPoint> control = {},
                                                   const PhotoCache* cache = nullptr);

}  // namespace hybridfusion
