#pragma once

#include "control_target.hpp"
#include "gnss_terms.hpp"
#include "placement.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <span>

namespace hybridfusion {

/// Fills the GNSS figures of `out` and judges place, scale and tilt of an adjusted model:
/// reprojection errors never show a wrong one.
void assess_georeference(const SfmModel& model,
                         const GnssTerms& terms,
                         const GnssIngest& gnss,
                         const Placement& placement,
                         ReconstructionQuality& out);

/// Height difference of the edge of a block against its middle, `after` less `before`, when the
/// similarity between the two is taken out: the quadric part of what an adjustment with GNSS did.
/// @param before  Camera centres before it; `after`: the same after it.
[[nodiscard]] double dome_between(std::span<const Eigen::Vector3d> before,
                                  std::span<const Eigen::Vector3d> after);

/// The same for a model that surveyed points place: by what they leave when held out one by one.
void judge_control(std::span<const ControlTarget> targets, Reconstruction& result);

}  // namespace hybridfusion
