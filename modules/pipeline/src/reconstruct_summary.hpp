#pragma once

#include "stage_runner.hpp"

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/io/photo_folder.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <cstdint>
#include <string_view>

namespace hybridfusion {

/// Where the poses of the photos come from.
enum class PoseSource : std::uint8_t {
  kAdjusted,  ///< Bundle adjustment: their uncertainty is known.
  kGiven,     ///< The user's model: nothing is known of it but what it says.
};

/// Verdict on scale and tilt in the place of "good", "limited" and "unusable" when poses were
/// given.
inline constexpr std::string_view kGivenPoses = "given";

/// What the stage says of its result: JSON for run.json, lines for a person. Refused when the
/// result has no place and no scale.
[[nodiscard]] StageResult reconstruct_summary(const Reconstruction& reconstruction,
                                              PoseSource source,
                                              const PhotoFolder& folder,
                                              const PointCloud& dense);

}  // namespace hybridfusion
