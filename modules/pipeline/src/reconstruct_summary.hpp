#pragma once

#include "stage_runner.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

namespace hybridfusion {

/// What the stage says of its result: JSON for run.json, lines for a person. Refused when the
/// result has no place and no scale.
[[nodiscard]] StageResult reconstruct_summary(const Reconstruction& reconstruction,
                                              const PhotoFolder& folder,
                                              const PointCloud& dense);

}  // namespace hybridfusion
