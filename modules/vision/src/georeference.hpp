#pragma once

#include "gnss_terms.hpp"
#include "placement.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

namespace hybridfusion {

/// Fills the GNSS figures of `out` and judges place, scale and tilt of an adjusted model:
/// reprojection errors never show a wrong one.
void assess_georeference(const SfmModel& model,
                         const GnssTerms& terms,
                         const GnssIngest& gnss,
                         const Placement& placement,
                         ReconstructionQuality& out);

}  // namespace hybridfusion
