#pragma once

#include "pair_selection.hpp"
#include "sfm_model.hpp"
#include "tracks.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Pairs that a first model suggests and that were not verified: registered photos that see the
/// same places by their poses but share no track, and photos that were left out, with twice as many
/// neighbours by position as before. Ascending.
/// @param model  In the east-north-up frame.
[[nodiscard]] std::vector<PhotoPair> second_round_pairs(const SfmModel& model,
                                                        std::span<const VerifiedPair> verified,
                                                        const GnssIngest& gnss,
                                                        const PairOptions& options);

}  // namespace hybridfusion
