#pragma once

#include "gnss_adjustment.hpp"

#include <hybridfusion/core/photo.hpp>

#include <span>

namespace hybridfusion {

/// What the final adjustment knows beside the model.
struct AdjustmentInputs {
  const GnssIngest& gnss;
  std::span<const PhotoMetadata> metadata;
  std::span<const ControlTarget> control;
  const ReconstructionOptions& options;
};

/// adjust_with_gnss(), and once more after the rolling shutter was undone where it matters. A
/// readout time of the table that makes the photos agree worse is not taken: the camera has another
/// mode or firmware than the one that was measured. One that the options state always is.
[[nodiscard]] Expected<void> adjust_with_shutter(SfmModel& model,
                                                 GnssTerms& terms,
                                                 const AdjustmentInputs& inputs,
                                                 const RunContext& ctx);

}  // namespace hybridfusion
