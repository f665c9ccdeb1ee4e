#pragma once

#include "image_plane.hpp"

#include <hybridfusion/vision/densify_options.hpp>

#include <cstdint>

namespace hybridfusion {

/// A rectified pair in grey. The point at (x, y) of the left image with disparity index k is at
/// (x - k + num_disparities - 1, y) of the right one, which is num_disparities - 1 columns wider.
struct RectifiedImages {
  ImagePlane<std::uint8_t> left = {};
  ImagePlane<std::uint8_t> right = {};
  ImagePlane<std::uint8_t> left_mask = {};  ///< 0 where the photo has no data.
  ImagePlane<std::uint8_t> right_mask = {};
  int num_disparities = 0;
};

/// Candidate disparities of each pixel: [low, low + count); count 0 leaves the pixel out.
struct DisparityRanges {
  ImagePlane<std::int16_t> low = {};
  ImagePlane<std::int16_t> count = {};
};

/// Every pixel with data may take every disparity.
[[nodiscard]] DisparityRanges full_ranges(const RectifiedImages& images);

/// Ranges at twice the resolution: around what the coarse result holds in a neighbourhood.
[[nodiscard]] DisparityRanges ranges_around(const ImagePlane<float>& coarse,
                                            const RectifiedImages& images);

/// Semi-global matching (Hirschmueller, PAMI 2008) of census codes along four or eight paths, with
/// left-right check, uniqueness and sub-pixel interpolation. Works in strips of rows within
/// `max_volume_mib`; the result does not depend on them.
/// @returns Disparity index a pixel of the left image; NaN where there is none.
[[nodiscard]] ImagePlane<float> match_semi_globally(const RectifiedImages& images,
                                                    const DisparityRanges& ranges,
                                                    const StereoOptions& options);

}  // namespace hybridfusion
