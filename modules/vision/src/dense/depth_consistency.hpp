#pragma once

#include "depth_map.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/densify_options.hpp>

#include <span>

namespace hybridfusion {

/// Depth and photometric consistency (HybridFusion III-A.2). A depth stays when enough other depth
/// maps agree, more than see through it, and when the photo looks the same there as at least one
/// other does. What stays becomes the inverse-variance mean of the agreeing depths: surfaces seen
/// from several photos are one sheet, not several.
///
/// @param others  Maps of the photos that see the same, those that judge first in front.
/// @returns       The reference's depth and sigma planes after the check.
struct CheckedDepth {
  ImagePlane<float> depth_m = {};
  ImagePlane<float> sigma_m = {};
};
[[nodiscard]] CheckedDepth check_depths(const DepthMap& reference,
                                        std::span<const DepthMap* const> others,
                                        const DepthCheckOptions& options,
                                        const RunContext& ctx);

}  // namespace hybridfusion
