#pragma once

#include "position_conflicts.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>
#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/vision/ground_control.hpp>

#include <vector>

namespace hybridfusion {

[[nodiscard]] PositionLimits limits_of(const VisionStageOptions& options);

/// geo.txt and gcp_list.txt among the photos, as OpenDroneMap keeps them, unless others are given.
[[nodiscard]] PhotoInputs with_files_beside(PhotoInputs inputs);

/// Reads the files of positions and puts the tags into the photos.
/// @returns The error of a file that cannot be read; kInsufficient when no tag names a photo.
[[nodiscard]] Expected<PositionSources> take_positions(const PhotoInputs& inputs,
                                                       PhotoFolder& folder);

/// What is amiss and does not refuse the run, a line each: conflicts, names that are no photo's,
/// and what was taken for granted.
/// @returns kInsufficient with the first conflict that refuses it.
[[nodiscard]] Expected<std::vector<std::string>> judged_positions(const PositionSources& sources,
                                                                  const PositionLimits& limits);

/// Surveyed points with the photos by index. A name that starts with "chk" is for checking only.
[[nodiscard]] std::vector<ControlPoint> control_points(const SurveyFile& survey,
                                                       const PhotoFolder& folder);

}  // namespace hybridfusion
