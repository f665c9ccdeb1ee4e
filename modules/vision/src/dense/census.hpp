#pragma once

#include "image_plane.hpp"

#include <cstdint>

namespace hybridfusion {

inline constexpr int kCensusHalfWidth = 4;  // 9 x 7 window: 62 comparisons fit one word
inline constexpr int kCensusHalfHeight = 3;

/// Census transform (Zabih and Woodfill 1994): a bit for each pixel of the 9 x 7 window around the
/// centre that is darker than it. Pixels beyond the border repeat the border.
[[nodiscard]] ImagePlane<std::uint64_t> census_transform(const ImagePlane<std::uint8_t>& grey);

}  // namespace hybridfusion
