#pragma once

#include "bundle_adjustment.hpp"
#include "placement.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

namespace hybridfusion {

/// GNSS of the registered views, with sigmas as stated.
[[nodiscard]] GnssTerms gnss_terms(const SfmModel& model,
                                   const GnssIngest& gnss,
                                   const GnssOptions& options,
                                   const Placement& placement);

/// Vision less GNSS position of the antenna, less the modelled errors of the tags, of every
/// observation [m].
[[nodiscard]] std::vector<Eigen::Vector3d> gnss_residuals(const SfmModel& model,
                                                          const GnssTerms& terms);

/// Final adjustments of an aligned model: reprojection and GNSS errors with all intrinsics, then
/// filtering and triangulating again; repeated. The deviations of pixels and of GNSS are estimated
/// from the residuals in between.
/// @param control  Surveyed points, which hold the model as GNSS does.
[[nodiscard]] Expected<void> adjust_with_gnss(SfmModel& model,
                                              GnssTerms& terms,
                                              std::span<const ControlTarget> control,
                                              const ReconstructionOptions& options,
                                              const RunContext& ctx);

}  // namespace hybridfusion
