#pragma once

#include "depth_map.hpp"
#include "device_matcher.hpp"
#include "pair_choice.hpp"
#include "work_images.hpp"

#include <hybridfusion/core/error.hpp>

#include <string>
#include <vector>

namespace hybridfusion {

/// What stereo found for a reference photo.
struct StereoDepthResult {
  DepthMap map = {};
  int num_pairs = 0;                       ///< That gave depths.
  std::vector<std::string> refusals = {};  ///< One for each pair left out.
};

/// Matches a photo with each of its partners, merges the depths on the photo's own grid and drops
/// those at depth steps and of the sky.
/// @param device  Matches instead of the CPU; may be null.
/// @param images  Those of the photo and its partners are used. @pre the photo itself can be
/// decoded
[[nodiscard]] StereoDepthResult stereo_depth(const Reconstruction& reconstruction,
                                             std::uint32_t reference,
                                             WorkImages& images,
                                             const DensifyOptions& options,
                                             DeviceMatcher* device = nullptr);

}  // namespace hybridfusion
