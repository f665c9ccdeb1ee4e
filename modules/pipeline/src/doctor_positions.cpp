#include "doctor_checks.hpp"

#include <hybridfusion/io/photo_metadata.hpp>
#include <hybridfusion/vision/gnss_ingest.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPositions = 3;
// No ground lies lower than the shore of the Dead Sea, and no ellipsoid-geoid gap exceeds 110 m.
constexpr double kLowestGround_m = -550.0;

bool has_position(const PhotoMetadata& photo) {
  return photo.latitude_deg && photo.longitude_deg;
}

/// Photos taken at different times at exactly the same place.
std::vector<std::string> repeated(std::span<const PhotoMetadata> photos) {
  std::map<std::pair<double, double>, std::vector<const PhotoMetadata*>> places;
  for (const PhotoMetadata& photo : photos) {
    if (has_position(photo)) places[{*photo.latitude_deg, *photo.longitude_deg}].push_back(&photo);
  }
  std::vector<std::string> names;
  for (const auto& [place, here] : places) {
    if (here.size() < 3) continue;  // a pair is a photo taken twice
    const bool timed = std::ranges::all_of(
        here, [&](const PhotoMetadata* photo) { return photo->time == here.front()->time; });
    if (timed && here.front()->time) continue;  // several cameras released together
    for (const PhotoMetadata* photo : here) names.push_back(photo->name);
  }
  return names;
}

/// Photos whose altitude fits the others with the opposite sign only.
std::vector<std::string> flipped_altitudes(std::span<const PhotoMetadata> photos) {
  std::vector<double> magnitudes;
  std::size_t positive = 0;
  for (const PhotoMetadata& photo : photos) {
    if (!photo.altitude_m || *photo.altitude_m == 0.0) continue;
    magnitudes.push_back(std::abs(*photo.altitude_m));
    if (*photo.altitude_m > 0.0) ++positive;
  }
  std::vector<std::string> names;
  if (magnitudes.empty()) return names;
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>(magnitudes.size() / 2);
  std::ranges::nth_element(magnitudes, middle);
  const double typical = *middle;
  for (const PhotoMetadata& photo : photos) {
    if (!photo.altitude_m || *photo.altitude_m >= 0.0) continue;
    const double altitude = *photo.altitude_m;
    const bool fits_flipped =
        positive > 0 && std::abs(-altitude - typical) < 0.25 * std::abs(altitude - typical);
    // The XMP altitude of the same fix, where it is kept, tells the sign.
    const bool contradicted = photo.absolute_altitude_m && *photo.absolute_altitude_m > 0.0 &&
                              std::abs(*photo.absolute_altitude_m + altitude) < 1.0;
    if (fits_flipped || contradicted || altitude < kLowestGround_m) names.push_back(photo.name);
  }
  return names;
}

/// Whether the reconstruction would take the altitude of one of these as it is; where another
/// source tells it, or it does not fit its neighbours, the run does without.
bool takes_altitude_of(std::span<const PhotoMetadata> photos,
                       const std::vector<std::string>& names,
                       const GnssOptions& options) {
  const auto ingest = ingest_gnss(photos, options);
  if (!ingest) return false;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const PhotoFix& fix = ingest->fixes[i];
    if (!fix.position_in_enu || !fix.has_altitude) continue;
    if (std::ranges::find(names, photos[i].name) == names.end()) continue;
    if (geodetic_from_enu(ingest->origin, *fix.position_in_enu).altitude_m < 0.0) return true;
  }
  return false;
}

void check_altitudes(std::span<const PhotoMetadata> photos,
                     const GnssOptions& options,
                     Diagnosis& diagnosis) {
  auto flipped = flipped_altitudes(photos);
  if (!flipped.empty()) {
    const bool spoils = takes_altitude_of(photos, flipped, options);
    diagnosis.findings.add(spoils ? "photos.altitude_sign" : "photos.altitude_ref",
                           fmt::format("{} of {} photos are below sea level: {}",
                                       flipped.size(),
                                       photos.size(),
                                       listed(flipped)),
                           flipped);
  }
  std::vector<std::string> without;
  for (const PhotoMetadata& photo : photos) {
    if (has_position(photo) && !known_altitude_m(photo)) without.push_back(photo.name);
  }
  if (!without.empty()) {
    diagnosis.findings.add(
        "photos.no_altitude",
        fmt::format("{} photos have no altitude: {}", without.size(), listed(without)),
        without);
  }
}

/// What the reconstruction will say of the positions.
void check_ingest(std::span<const PhotoMetadata> photos,
                  const GnssOptions& options,
                  Diagnosis& diagnosis) {
  const auto ingest = ingest_gnss(photos, options);
  auto same = repeated(photos);
  if (!ingest) {
    const bool repeats = 2 * same.size() > photos.size();
    diagnosis.findings.add(
        repeats ? "photos.same_position" : "photos.no_positions", ingest.error().message, same);
    return;
  }
  std::vector<std::string> names;
  std::string first;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    const PhotoFix& fix = ingest->fixes[i];
    if (fix.position_in_enu || !has_position(photos[i])) continue;
    if (names.empty()) first = fix.rejection;
    names.push_back(photos[i].name);
  }
  if (!names.empty()) {
    diagnosis.findings.add(
        "photos.bad_position", fmt::format("{}: {}", listed(names), first), names);
  }
  if (!same.empty()) {
    diagnosis.findings.add(
        "photos.repeated_position",
        fmt::format("{} photos at exactly the same place as others: {}", same.size(), listed(same)),
        same);
  }
}

}  // namespace

std::optional<double> known_altitude_m(const PhotoMetadata& photo) {
  if (photo.absolute_altitude_m) return photo.absolute_altitude_m;
  return photo.altitude_m.value_or(0.0) != 0.0 ? photo.altitude_m : std::nullopt;
}

void check_positions(const std::filesystem::path& folder,
                     std::span<const PhotoMetadata> photos,
                     std::size_t num_control,
                     const GnssOptions& options,
                     Diagnosis& diagnosis) {
  std::vector<std::string> null;
  std::vector<std::string> without;
  for (const PhotoMetadata& photo : photos) {
    if (has_position(photo)) continue;
    without.push_back(photo.name);
    if (has_null_position(folder / photo.name)) null.push_back(photo.name);
  }
  if (!null.empty()) {
    diagnosis.findings.add("photos.null_position",
                           fmt::format("{} photos say (0, 0): {}", null.size(), listed(null)),
                           null);
  }
  const std::size_t positioned = photos.size() - without.size();
  const std::string cause =
      fmt::format("{} of {} photos have a position", positioned, photos.size());
  diagnosis.facts.push_back(cause);
  if (positioned < kMinPositions && num_control >= kMinPositions) {
    diagnosis.facts.emplace_back("ground control places the photos");
    return;
  }
  if (positioned < kMinPositions) {
    diagnosis.findings.add("photos.no_positions", cause, without);
    return;
  }
  if (!without.empty()) {
    diagnosis.findings.add(
        "photos.some_without_position", fmt::format("{}; not {}", cause, listed(without)), without);
  }
  check_altitudes(photos, options, diagnosis);
  check_ingest(photos, options, diagnosis);
}

}  // namespace hybridfusion
