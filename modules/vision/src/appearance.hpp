#pragma once

#include "features.hpp"
#include "pair_selection.hpp"

#include <hybridfusion/core/run_context.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Pairs of photos that look alike: each with its `count` nearest by VLAD descriptors (Jegou et
/// al., CVPR 2010) over 64 words of the photos' own SIFT descriptors. Ascending; for photos without
/// a position.
[[nodiscard]] std::vector<PhotoPair> similar_photos(std::span<const FeatureSet> features,
                                                    int count,
                                                    const RunContext& ctx);

}  // namespace hybridfusion
