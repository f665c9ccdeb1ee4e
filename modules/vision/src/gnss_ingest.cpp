#include "robust_statistics.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kFlightGap_s = 600.0;

std::vector<std::size_t> order_by_time(std::span<const PhotoMetadata> photos) {
  std::vector<std::size_t> order(photos.size());
  std::iota(order.begin(), order.end(), 0);
  if (!std::ranges::all_of(photos, [](const auto& p) { return p.time.has_value(); })) return order;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return *photos[i].time; });
  return order;
}

bool has_position(const PhotoMetadata& photo) {
  if (!photo.latitude_deg || !photo.longitude_deg) return false;
  const double lat = *photo.latitude_deg;
  const double lon = *photo.longitude_deg;
  return std::isfinite(lat) && std::isfinite(lon) && std::abs(lat) <= 90.0 &&
         std::abs(lon) <= 180.0 && !(lat == 0.0 && lon == 0.0);
}

/// EXIF and XMP altitudes may use different references (sea level, ellipsoid, take-off): a mixture
/// would tilt the model, so one source serves all photos.
using AltitudeSource = std::optional<double> PhotoMetadata::*;

AltitudeSource choose_altitude(std::span<const PhotoMetadata> photos) {
  const auto usable = [&](AltitudeSource source) {
    return std::ranges::count_if(photos, [&](const PhotoMetadata& p) {
      return has_position(p) && p.*source && std::isfinite(*(p.*source)) && *(p.*source) != 0.0;
    });
  };
  // XMP carries more digits and, on some firmware, the right sign.
  return usable(&PhotoMetadata::absolute_altitude_m) >= usable(&PhotoMetadata::altitude_m)
             ? &PhotoMetadata::absolute_altitude_m
             : &PhotoMetadata::altitude_m;
}

Eigen::Vector3d stated_sigma(const PhotoMetadata& photo, const GnssOptions& options, bool& is_rtk) {
  is_rtk = photo.rtk_sigma_enu_m && photo.rtk_sigma_enu_m->allFinite() &&
           photo.rtk_sigma_enu_m->minCoeff() > 0.0;
  if (is_rtk) return photo.rtk_sigma_enu_m->cwiseMax(options.min_sigma_rtk_m);
  double horizontal = options.default_sigma_m;
  if (photo.gps_horizontal_error_m && *photo.gps_horizontal_error_m > 0.0) {
    horizontal = *photo.gps_horizontal_error_m;
  } else if (photo.gps_dop && *photo.gps_dop > 0.0) {
    horizontal = *photo.gps_dop * options.sigma_per_dop_m;
  }
  const double vertical = std::max(2.0 * horizontal, options.min_sigma_vertical_m);
  return {horizontal, horizontal, vertical};
}

double median_of(std::span<const PhotoMetadata> photos, const auto& value_of) {
  std::vector<double> values;
  for (const PhotoMetadata& photo : photos) {
    if (const auto value = value_of(photo)) values.push_back(*value);
  }
  return values.empty() ? 0.0 : median(values);
}

/// Most photos at one place: a receiver without a fix repeats its last position.
bool mostly_identical(std::span<const PhotoMetadata> photos) {
  std::vector<std::array<double, 2>> places;
  for (const PhotoMetadata& p : photos) {
    if (has_position(p)) places.push_back({*p.latitude_deg, *p.longitude_deg});
  }
  std::ranges::sort(places);
  std::size_t longest = 0;
  for (std::size_t i = 0, run = 0; i < places.size(); ++i) {
    run = i > 0 && places[i] == places[i - 1] ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest > 2 && 2 * longest > places.size();
}

/// Rejects what is far from both neighbours in time: distance to the nearer one, against its
/// median over the photos.
void reject_jumps(GnssIngest& ingest, const GnssOptions& options) {
  std::vector<std::size_t> used;
  for (const std::size_t i : ingest.by_time) {
    if (ingest.fixes[i].position_in_enu) used.push_back(i);
  }
  if (used.size() < 4) return;
  const auto gap = [&](std::size_t a, std::size_t b, auto&& part) {
    return part(*ingest.fixes[used[a]].position_in_enu - *ingest.fixes[used[b]].position_in_enu);
  };
  const auto nearer = [&](auto&& part) {
    std::vector<double> distances(used.size());
    for (std::size_t k = 0; k < used.size(); ++k) {
      // The ends have one neighbour in time, so that their second nearest takes the other's place.
      const std::size_t before = k > 0 ? k - 1 : 2;
      const std::size_t after = k + 1 < used.size() ? k + 1 : k - 2;
      distances[k] = std::min(gap(k, before, part), gap(k, after, part));
    }
    return distances;
  };
  const auto limit = [&](std::vector<double> d) {
    return std::max(options.max_jump_m, median(d) + 5.0 * robust_sigma(d));
  };
  const std::vector<double> horizontal =
      nearer([](const Eigen::Vector3d& d) { return d.head<2>().norm(); });
  const std::vector<double> vertical =
      nearer([](const Eigen::Vector3d& d) { return std::abs(d.z()); });
  const double horizontal_limit = limit(horizontal);
  const double vertical_limit = limit(vertical);
  for (std::size_t k = 0; k < used.size(); ++k) {
    PhotoFix& fix = ingest.fixes[used[k]];
    if (horizontal[k] > horizontal_limit) {
      fix.rejection =
          fmt::format("GNSS position is {:.0f} m from its neighbours in time (limit {:.0f})",
                      horizontal[k],
                      horizontal_limit);
      fix.position_in_enu.reset();
    } else if (vertical[k] > vertical_limit) {
      fix.has_altitude = false;
    }
  }
}

void number_flights(GnssIngest& ingest, std::span<const PhotoMetadata> photos) {
  int flight = 0;
  std::size_t first = ingest.by_time.empty() ? 0 : ingest.by_time.front();
  for (std::size_t k = 0; k < ingest.by_time.size(); ++k) {
    const std::size_t i = ingest.by_time[k];
    const PhotoMetadata& previous = photos[ingest.by_time[k > 0 ? k - 1 : 0]];
    const bool timed = photos[i].time && previous.time;
    const bool gap = timed && to_seconds(*photos[i].time - *previous.time) > kFlightGap_s;
    if (gap || photos[i].serial != previous.serial) {
      ++flight;
      first = i;
    }
    ingest.fixes[i].flight = flight;
    if (photos[i].time && photos[first].time) {
      ingest.fixes[i].flight_time_s = to_seconds(*photos[i].time - *photos[first].time);
    }
  }
}

/// A wrong GPSAltitudeRef: the height of the result is off, its shape is not.
void warn_below_sea(GnssIngest& ingest) {
  constexpr double kDeadSea_m = -50.0;  // few flights are lower
  if (ingest.origin.altitude_m > kDeadSea_m) return;
  ingest.warnings.push_back(
      fmt::format("the photos lie {:.0f} m below sea level: if the place does not, GPSAltitudeRef "
                  "is wrong and so is the height of the result",
                  -ingest.origin.altitude_m));
}

Expected<void> check_enough(const GnssIngest& ingest) {
  const auto used = std::ranges::count_if(
      ingest.fixes, [](const PhotoFix& fix) { return fix.position_in_enu.has_value(); });
  if (used >= 3) return {};
  return fail(ErrorCode::kInsufficient,
              fmt::format("only {} of {} photos have a usable GNSS position, 3 are needed; geotag "
                          "the photos (EXIF GPSLatitude, GPSLongitude, GPSAltitude) and run again",
                          used,
                          ingest.fixes.size()));
}

}  // namespace

Expected<GnssIngest> ingest_gnss(std::span<const PhotoMetadata> photos,
                                 const GnssOptions& options) {
  GnssIngest ingest;
  ingest.fixes.resize(photos.size());
  ingest.by_time = order_by_time(photos);
  if (mostly_identical(photos)) {
    return fail(ErrorCode::kInsufficient,
                "more than half of the photos carry the same GNSS position: the receiver had no "
                "fix; geotag the photos from a flight log and run again");
  }
  const AltitudeSource altitude_of = choose_altitude(photos);
  const auto altitude = [&](const PhotoMetadata& p) -> std::optional<double> {
    const std::optional<double>& value = p.*altitude_of;
    return value && std::isfinite(*value) && *value != 0.0 ? value : std::nullopt;
  };
  ingest.origin.latitude_deg = median_of(
      photos, [](const auto& p) { return has_position(p) ? p.latitude_deg : std::nullopt; });
  ingest.origin.longitude_deg = median_of(
      photos, [](const auto& p) { return has_position(p) ? p.longitude_deg : std::nullopt; });
  ingest.origin.altitude_m = median_of(
      photos, [&](const auto& p) { return has_position(p) ? altitude(p) : std::nullopt; });

  for (std::size_t i = 0; i < photos.size(); ++i) {
    PhotoFix& fix = ingest.fixes[i];
    if (!has_position(photos[i])) {
      fix.rejection = photos[i].latitude_deg ? "GNSS position is 0, 0 or out of range"
                                             : "no GNSS position in the metadata";
      continue;
    }
    fix.sigma_m = stated_sigma(photos[i], options, fix.is_rtk);
    fix.has_altitude = altitude(photos[i]).has_value();
    fix.position_in_enu =
        enu_from_geodetic(ingest.origin,
                          {.latitude_deg = *photos[i].latitude_deg,
                           .longitude_deg = *photos[i].longitude_deg,
                           .altitude_m = altitude(photos[i]).value_or(ingest.origin.altitude_m)});
  }
  number_flights(ingest, photos);
  warn_below_sea(ingest);
  reject_jumps(ingest, options);
  if (auto enough = check_enough(ingest); !enough) return std::unexpected(enough.error());
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const PhotoFix& fix = ingest.fixes[i];
    if (!fix.rejection.empty()) {
      ingest.warnings.push_back(photos[i].name + ": " + fix.rejection);
    } else if (!fix.has_altitude) {
      ingest.warnings.push_back(photos[i].name + ": GNSS altitude is missing or implausible");
    }
  }
  return ingest;
}

GnssIngest without_gnss(std::span<const PhotoMetadata> photos, const std::string& reason) {
  GnssIngest ingest;
  ingest.fixes.resize(photos.size());
  ingest.by_time = order_by_time(photos);
  number_flights(ingest, photos);
  for (PhotoFix& fix : ingest.fixes) fix.rejection = reason;
  ingest.warnings = {reason};
  return ingest;
}

}  // namespace hybridfusion
