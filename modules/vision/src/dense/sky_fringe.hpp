#pragma once

#include "depth_map.hpp"

namespace hybridfusion {

/// Drops depths of pixels that show the sky beside an object: between the bars of a railing, among
/// twigs, along a rim, where the matching window saw the object. Sky is what has neither texture
/// nor depth, lies above the horizon (z of `enu_from_camera` is up) and reaches the photo's border;
/// within `reach_px` of it, whatever has its colour rather than that of the object beside it.
/// @param min_grey  As in weak_texture(). @param reach_px  0 drops nothing.
void drop_sky_fringe(DepthMap& map, double min_grey, int reach_px);

}  // namespace hybridfusion
