#include "photo_places.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {

std::vector<std::optional<PhotoPlace>> places_of(std::span<const PhotoMetadata> photos,
                                                 const GnssOptions& options) {
  std::vector<std::optional<PhotoPlace>> places(photos.size());
  const auto ingest = ingest_gnss(photos, options);
  if (!ingest) return places;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const PhotoFix& fix = ingest->fixes[i];
    if (!fix.position_in_enu) continue;
    PhotoPlace place{.at = geodetic_from_enu(ingest->origin, *fix.position_in_enu),
                     .has_altitude = fix.has_altitude,
                     .sigma_horizontal_m = fix.sigma_m.head<2>().maxCoeff(),
                     .sigma_vertical_m = fix.sigma_m.z()};
    // Heights without RTK are not believed to better than the option says.
    place.sigma_vertical_m = std::max(place.sigma_vertical_m, options.min_sigma_vertical_m);
    if (fix.is_rtk) {
      place.sigma_horizontal_m = std::max(place.sigma_horizontal_m, options.default_sigma_m);
    }
    places[i] = place;
  }
  return places;
}

std::string place_text(const GeodeticPosition& position) {
  return fmt::format(
      "latitude {:.6f}, longitude {:.6f}", position.latitude_deg, position.longitude_deg);
}

std::string distance_text(double distance_m) {
  if (distance_m >= 10000.0) return fmt::format("{:.0f} km", distance_m / 1000.0);
  if (distance_m >= 1000.0) return fmt::format("{:.1f} km", distance_m / 1000.0);
  if (distance_m >= 100.0) return fmt::format("{:.0f} m", distance_m);
  return distance_m >= 0.1 ? fmt::format("{:.1f} m", distance_m)
                           : fmt::format("{:.3g} mm", 1000.0 * distance_m);
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace hybridfusion
