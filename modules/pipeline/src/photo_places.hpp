#pragma once

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/io/geo_tags.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Where a photo is and how well that is known, by one source.
struct PhotoPlace {
  GeodeticPosition at = {};
  bool has_altitude = false;
  /// Against another source: a receiver states how well it knows its place on Earth, but with RTK
  /// only that from its base, whose own place may be as uncertain as any fix.
  double sigma_horizontal_m = 0.0;
  double sigma_vertical_m = 0.0;
};

/// One per photo; empty where the position is absent or rejected, all when there are too few.
[[nodiscard]] std::vector<std::optional<PhotoPlace>> places_of(
    std::span<const PhotoMetadata> photos, const GnssOptions& options);

/// "latitude 48.150300, longitude 11.568200"
[[nodiscard]] std::string place_text(const GeodeticPosition& position);
/// "5.2 m", "446 km"
[[nodiscard]] std::string distance_text(double distance_m);

[[nodiscard]] double median_of(std::vector<double> values);

}  // namespace hybridfusion
