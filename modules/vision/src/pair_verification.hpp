#pragma once

#include "features.hpp"
#include "intrinsics_prior.hpp"
#include "matching.hpp"
#include "pair_selection.hpp"
#include "tracks.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// Descriptor matches of a pair before geometry had its say.
struct RawPair {
  PhotoPair views = {};
  std::vector<Match> matches = {};
};

/// In the order of `pairs`. @param cache  Of the photos, by index; may be null.
[[nodiscard]] Expected<std::vector<RawPair>> match_pairs(std::span<const FeatureSet> features,
                                                         std::span<const PhotoPair> pairs,
                                                         const MatchingOptions& options,
                                                         const RunContext& ctx,
                                                         const PhotoCache* cache = nullptr);

/// The matches of a pair that agree with one relative pose; nullopt for too few.
[[nodiscard]] std::optional<VerifiedPair> verify_pair(std::span<const FeatureSet> features,
                                                      const CameraSetup& cameras,
                                                      const RawPair& pair,
                                                      const MatchingOptions& options,
                                                      const RunContext& ctx);

/// All pairs that pass verify_pair, in the order given.
[[nodiscard]] Expected<std::vector<VerifiedPair>> verify_pairs(std::span<const FeatureSet> features,
                                                               const CameraSetup& cameras,
                                                               std::span<const RawPair> pairs,
                                                               const MatchingOptions& options,
                                                               const RunContext& ctx);

/// Sets k1 of every camera, and the focal length where it was guessed, to what makes most matches
/// of the best connected pairs agree with a relative pose. Metadata do not hold the distortion, and
/// verification with a wrong one loses the matches at the image border.
void probe_lenses(CameraSetup& cameras,
                  std::span<const FeatureSet> features,
                  std::span<const RawPair> pairs,
                  const RunContext& ctx);

}  // namespace hybridfusion
