#pragma once

#include "device_matcher.hpp"
#include "semi_global_matching.hpp"

#include <hybridfusion/core/error.hpp>

namespace hybridfusion {

/// Disparity index of each left pixel (NaN: none) by the matcher that the options name, with weakly
/// textured windows, small islands and outliers removed, refined to sub-pixel on the grey values.
/// @param device  Matches instead of the CPU; may be null.
/// @returns kInsufficient when OpenCV's matcher fails.
[[nodiscard]] Expected<ImagePlane<float>> match_pair(const RectifiedImages& images,
                                                     const StereoOptions& options,
                                                     DeviceMatcher* device = nullptr);

/// Half the size by averaging 2 x 2 pixels; a pixel has data when all four have. Disparity index k
/// becomes k / 2. @pre num_disparities is odd
[[nodiscard]] RectifiedImages half_size(const RectifiedImages& images);

/// Median of the valid values in 3 x 3 pixels where at least five are valid; else unchanged.
[[nodiscard]] ImagePlane<float> median_filtered(const ImagePlane<float>& disparity);

/// Invalidates regions of fewer than `min_segment_px` pixels whose disparities differ from their
/// neighbours' by at most one.
void remove_small_segments(ImagePlane<float>& disparity, int min_segment_px);

/// Sub-pixel refinement: shifts each disparity so that grey windows agree best up to gain and
/// offset, one Gauss-Newton step of a least-squares match (Lucas and Kanade 1981) along the row,
/// repeated. The windows follow the local slope of the surface.
[[nodiscard]] ImagePlane<float> refine_on_grey_values(const RectifiedImages& images,
                                                      const ImagePlane<float>& disparity);

}  // namespace hybridfusion
