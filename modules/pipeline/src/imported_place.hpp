#pragma once

#include "position_conflicts.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <span>
#include <string>

namespace hybridfusion {

/// Puts a model of given poses into the plane of the photos' own positions.
/// @returns kInsufficient with fewer than three of them.
[[nodiscard]] Expected<void> place_by_photos(std::span<const Photo> photos,
                                             const GnssOptions& options,
                                             Reconstruction& reconstruction);

/// Notes where GNSS saw the photos of a model that has its place already.
void note_positions(std::span<const Photo> photos,
                    const GnssOptions& options,
                    Reconstruction& reconstruction);

/// The place of the model against that of the photos; what is amiss and no error is a warning.
/// @returns kInsufficient with both places where they contradict each other.
[[nodiscard]] Expected<void> judge_place(const std::string& placed_by,
                                         const PositionLimits& limits,
                                         Reconstruction& reconstruction);

/// Reprojection errors and differences from GNSS.
void measure_quality(Reconstruction& reconstruction);

}  // namespace hybridfusion
