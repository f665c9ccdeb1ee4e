#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hybridfusion {

/// Up to this many photos, those without a position are matched with all others.
inline constexpr std::size_t kAllPairsPhotos = 60;

/// first < second, both photo indices.
struct PhotoPair {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  friend auto operator<=>(const PhotoPair&, const PhotoPair&) = default;
};

/// Pairs worth matching, ascending: neighbours by position, by the point on the ground under the
/// optical axis where gimbal angles and height above take-off are known, and in time. Photos
/// without a position are matched with more neighbours in time (with all, in small sets).
[[nodiscard]] std::vector<PhotoPair> select_pairs(std::span<const PhotoMetadata> photos,
                                                  const GnssIngest& gnss,
                                                  const PairOptions& options);

}  // namespace hybridfusion
