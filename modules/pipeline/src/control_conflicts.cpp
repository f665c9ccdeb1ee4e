#include "control_conflicts.hpp"

#include "finding_list.hpp"
#include "photo_places.hpp"

#include <hybridfusion/io/coordinate_cause.hpp>
#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kUnknownHeight_m = 500.0;  // generous, so that only certain gaps are reported
// 84 degrees from the vertical, where a camera sees the horizon rather than a mark.
constexpr double kLongestView = 10.0;

/// The photos that can show a point, as one.
struct Flight {
  double radius_m = 0.0;    ///< Of the block.
  double altitude_m = NAN;  ///< Median; NaN where no altitude is known.
  double sigma_horizontal_m = 0.0;
  double sigma_vertical_m = 0.0;
};

Flight flight_of(const std::vector<PhotoPlace>& places) {
  std::vector<double> latitudes;
  std::vector<double> longitudes;
  std::vector<double> altitudes;
  Flight flight;
  for (const PhotoPlace& place : places) {
    latitudes.push_back(place.at.latitude_deg);
    longitudes.push_back(place.at.longitude_deg);
    if (place.has_altitude) altitudes.push_back(place.at.altitude_m);
    flight.sigma_horizontal_m = std::max(flight.sigma_horizontal_m, place.sigma_horizontal_m);
    flight.sigma_vertical_m = std::max(flight.sigma_vertical_m, place.sigma_vertical_m);
  }
  const GeodeticPosition middle{.latitude_deg = median_of(std::move(latitudes)),
                                .longitude_deg = median_of(std::move(longitudes))};
  for (const PhotoPlace& place : places) {
    flight.radius_m = std::max(flight.radius_m, ground_distance_m(middle, place.at));
  }
  if (!altitudes.empty()) flight.altitude_m = median_of(std::move(altitudes));
  return flight;
}

/// Farthest from its photos that a point can lie and still be seen [m].
double reach_m(const Flight& flight, double point_altitude_m, double max_sigma) {
  constexpr double kHighest_m = 20000.0;  // of any aircraft; a wrong height must not widen it
  const double above_m = std::isfinite(flight.altitude_m)
                             ? std::min(std::abs(flight.altitude_m - point_altitude_m), kHighest_m)
                             : kUnknownHeight_m;
  return flight.radius_m + kLongestView * std::max(above_m, flight.sigma_vertical_m) +
         max_sigma * flight.sigma_horizontal_m;
}

struct FarPoint {
  const SurveyedPoint* point = nullptr;
  GeodeticPosition nearest = {};
  double gap_m = std::numeric_limits<double>::infinity();
  double reach_m = 0.0;
};

PositionConflict far_conflict(const std::vector<FarPoint>& far, const PositionSources& sources) {
  std::vector<std::string> names;
  for (const FarPoint& point : far) names.push_back(point.point->name);
  const FarPoint& first = far.front();
  const std::string cause = horizontal_cause({.system = sources.control.system,
                                              .written = first.point->written,
                                              .position = first.point->position},
                                             first.nearest,
                                             std::max(first.reach_m, 0.01 * first.gap_m));
  return {.id = "control.far",
          .text = fmt::format("{}: point {} lies at {}, the nearest photo at {}: {} apart, {} is "
                              "the limit; so {} of {} points{}",
                              sources.control_path->string(),
                              first.point->name,
                              place_text(first.point->position),
                              place_text(first.nearest),
                              distance_text(first.gap_m),
                              distance_text(first.reach_m),
                              far.size(),
                              sources.control.points.size(),
                              cause.empty() ? std::string() : ": " + cause),
          .subjects = names};
}

/// Marks in photos that are not there.
void check_names(const PositionSources& sources,
                 const PhotoNames& names,
                 std::vector<PositionConflict>& out) {
  std::vector<std::string> unknown;
  std::size_t known = 0;
  for (const SurveyedPoint& point : sources.control.points) {
    for (const SurveyedPoint::Mark& mark : point.marks) {
      if (names.find(mark.photo)) {
        ++known;
      } else {
        unknown.push_back(mark.photo);
      }
    }
  }
  if (unknown.empty()) return;
  const std::size_t count = unknown.size();
  std::ranges::sort(unknown);
  const auto twice = std::ranges::unique(unknown);
  unknown.erase(twice.begin(), twice.end());
  out.push_back({.id = known > 0 ? "control.unknown_photos" : "control.no_photos",
                 .text = fmt::format("{}: {} of {} marks name photos that are not there: {}",
                                     sources.control_path->string(),
                                     count,
                                     count + known,
                                     listed(unknown)),
                 .subjects = unknown});
}

}  // namespace

std::vector<PositionConflict> compare_control(const PositionSources& sources,
                                              const PositionLimits& limits) {
  std::vector<PositionConflict> out;
  std::vector<std::string> names;
  for (const PhotoMetadata& photo : sources.used) names.push_back(photo.name);
  check_names(sources, PhotoNames(names), out);
  std::vector<PhotoPlace> places;
  for (const auto& place : places_of(sources.used, limits.gnss)) {
    if (place) places.push_back(*place);
  }
  if (places.empty()) return out;
  const Flight flight = flight_of(places);
  std::vector<FarPoint> far;
  std::vector<std::string> above;
  double highest_m = -std::numeric_limits<double>::infinity();
  const double margin_m = limits.max_sigma * flight.sigma_vertical_m;
  for (const SurveyedPoint& point : sources.control.points) {
    FarPoint at{.point = &point,
                .reach_m = reach_m(flight, point.position.altitude_m, limits.max_sigma)};
    for (const PhotoPlace& place : places) {
      const double gap_m = ground_distance_m(point.position, place.at);
      if (gap_m < at.gap_m) {
        at.gap_m = gap_m;
        at.nearest = place.at;
      }
    }
    if (at.gap_m > at.reach_m) {
      far.push_back(at);
    } else if (point.position.altitude_m > flight.altitude_m + margin_m) {
      above.push_back(point.name);
      highest_m = std::max(highest_m, point.position.altitude_m);
    }
  }
  if (!far.empty()) out.push_back(far_conflict(far, sources));
  if (!above.empty()) {
    out.push_back({.id = "control.above",
                   .text = fmt::format("{}: {} points lie above the photos, up to {:.1f} m against "
                                       "{:.1f} m (median): {}",
                                       sources.control_path->string(),
                                       above.size(),
                                       highest_m,
                                       flight.altitude_m,
                                       listed(above)),
                   .subjects = above});
  }
  return out;
}

}  // namespace hybridfusion
