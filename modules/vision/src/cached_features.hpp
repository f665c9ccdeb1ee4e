#pragma once

#include "features.hpp"
#include "matching.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Features of a photo, from the cache where it has them. @param cache  May be null.
/// @returns the photo's own error; kParse when it decodes to another size than its header states.
[[nodiscard]] Expected<FeatureSet> photo_features(const Photo& photo,
                                                  std::size_t index,
                                                  const FeatureOptions& options,
                                                  const PhotoCache* cache);

/// match_features of two photos, from the cache where it has them. @param cache  May be null.
[[nodiscard]] std::vector<Match> photo_matches(const FeatureSet& first,
                                               const FeatureSet& second,
                                               std::size_t first_index,
                                               std::size_t second_index,
                                               double ratio,
                                               const PhotoCache* cache);

/// Exact bytes with a checksum, and back; nothing for bytes that are not what to_bytes wrote.
[[nodiscard]] std::string to_bytes(const FeatureSet& features);
[[nodiscard]] std::string to_bytes(const std::vector<Match>& matches);
[[nodiscard]] std::optional<FeatureSet> features_from_bytes(std::string_view bytes);
[[nodiscard]] std::optional<std::vector<Match>> matches_from_bytes(std::string_view bytes);

}  // namespace hybridfusion
