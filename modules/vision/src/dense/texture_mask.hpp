#pragma once

#include "image_plane.hpp"

#include <cstdint>

namespace hybridfusion {

/// Pixels that cannot be matched (1; else 0): those whose census window has a standard deviation
/// below `min_grey`, less where the window is dark, as shadow dims texture and noise alike; and,
/// within a window's reach of them, those that are blank in a window of 3 x 3 already. There a
/// larger window holds the other side of an edge and would give its disparity to sky or blank wall.
[[nodiscard]] ImagePlane<std::uint8_t> weak_texture(const ImagePlane<std::uint8_t>& grey,
                                                    double min_grey);

}  // namespace hybridfusion
