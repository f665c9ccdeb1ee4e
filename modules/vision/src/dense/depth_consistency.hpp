#pragma once

#include "depth_map.hpp"

#include <hybridfusion/vision/densify_options.hpp>

#include <span>

namespace hybridfusion {

/// Depth and photometric consistency (HybridFusion III-A.2). A depth stays when enough other depth
/// maps agree, more than see through it, and when the photo looks the same there as at least one
/// other does. What stays becomes the inverse-variance mean of the agreeing depths: surfaces seen
/// from several photos are one sheet, not several.
///
/// @param maps   One per view; views without depths are empty.
/// @returns      The reference's depth and sigma planes after the check.
struct CheckedDepth {
  ImagePlane<float> depth_m = {};
  ImagePlane<float> sigma_m = {};
};
[[nodiscard]] CheckedDepth check_depths(std::span<const DepthMap> maps,
                                        std::uint32_t reference,
                                        const DepthCheckOptions& options);

}  // namespace hybridfusion
