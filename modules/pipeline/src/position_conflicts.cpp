#include "position_conflicts.hpp"

#include "control_conflicts.hpp"
#include "finding_list.hpp"
#include "photo_places.hpp"

#include <hybridfusion/io/coordinate_cause.hpp>
#include <hybridfusion/io/photo_names.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

using Places = std::vector<std::optional<PhotoPlace>>;

std::string behind(const std::string& cause) {
  return cause.empty() ? std::string() : ": " + cause;
}

/// One photo whose place two sources state.
struct Pair {
  std::size_t photo = 0;
  double gap_m = 0.0;
  double limit_m = 0.0;
};

/// The pair in the middle of all, by gap.
const Pair& middle_of(std::vector<Pair>& pairs) {
  const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
  std::ranges::nth_element(pairs, middle, {}, &Pair::gap_m);
  return *middle;
}

class TagComparison {
 public:
  TagComparison(const PositionSources& sources, const PositionLimits& limits)
      : sources_(sources),
        limits_(limits),
        own_(places_of(sources.own, limits.gnss)),
        used_(places_of(sources.used, limits.gnss)) {
    std::vector<std::string> names;
    for (const PhotoMetadata& photo : sources.used) names.push_back(photo.name);
    const PhotoNames index(names);
    tag_of_.resize(names.size(), nullptr);
    for (const GeoTag& tag : sources.tags.tags) {
      if (const auto at = index.find(tag.photo)) tag_of_[*at] = &tag;
    }
  }

  void compare(std::vector<PositionConflict>& out) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < own_.size(); ++i) {
      if (!own_[i] || !used_[i] || tag_of_[i] == nullptr) continue;
      pairs.push_back({.photo = i,
                       .gap_m = ground_distance_m(own_[i]->at, used_[i]->at),
                       .limit_m = limits_.max_sigma * std::hypot(own_[i]->sigma_horizontal_m,
                                                                 used_[i]->sigma_horizontal_m)});
    }
    if (pairs.empty()) return;
    std::vector<std::string> beyond;
    for (const Pair& pair : pairs) {
      if (pair.gap_m > pair.limit_m) beyond.push_back(sources_.used[pair.photo].name);
    }
    if (2 * beyond.size() > pairs.size()) {
      report_apart(middle_of(pairs), pairs.size(), beyond, out);
    } else {
      if (!beyond.empty()) {
        out.push_back({.id = "positions.some_differ",
                       .text = fmt::format("{}: {} of {} positions contradict the photos' own: {}",
                                           sources_.tags_path->string(),
                                           beyond.size(),
                                           pairs.size(),
                                           listed(beyond)),
                       .subjects = beyond});
      }
      compare_heights(pairs, out);
    }
  }

 private:
  void report_apart(const Pair& pair,
                    std::size_t num_pairs,
                    const std::vector<std::string>& beyond,
                    std::vector<PositionConflict>& out) const {
    const GeoTag& tag = *tag_of_[pair.photo];
    const std::string cause =
        horizontal_cause({.system = sources_.tags.system,
                          .written = tag.written,
                          .position = {tag.latitude_deg, tag.longitude_deg, 0.0}},
                         own_[pair.photo]->at,
                         std::max(pair.limit_m, 0.01 * pair.gap_m));
    out.push_back(
        {.id = "positions.contradict",
         .text = fmt::format("{} puts {} at {}, the photo's own GNSS at {}: {} apart, {} is the "
                             "limit; so {} of {} photos{}",
                             sources_.tags_path->string(),
                             sources_.used[pair.photo].name,
                             place_text(used_[pair.photo]->at),
                             place_text(own_[pair.photo]->at),
                             distance_text(pair.gap_m),
                             distance_text(pair.limit_m),
                             beyond.size(),
                             num_pairs,
                             behind(cause)),
         .subjects = beyond});
  }

  void compare_heights(const std::vector<Pair>& pairs, std::vector<PositionConflict>& out) const {
    std::vector<double> tagged;
    std::vector<double> own;
    std::vector<double> gaps;
    std::vector<double> limits;
    for (const Pair& pair : pairs) {
      const PhotoPlace& a = *own_[pair.photo];
      const PhotoPlace& b = *used_[pair.photo];
      if (!a.has_altitude || !b.has_altitude) continue;
      own.push_back(a.at.altitude_m);
      tagged.push_back(b.at.altitude_m);
      gaps.push_back(b.at.altitude_m - a.at.altitude_m);
      limits.push_back(limits_.max_sigma * std::hypot(a.sigma_vertical_m, b.sigma_vertical_m));
    }
    if (gaps.empty()) return;
    const double gap_m = median_of(std::move(gaps));
    const double limit_m = median_of(std::move(limits));
    if (std::abs(gap_m) <= limit_m) return;
    GeodeticPosition reference = own_[pairs.front().photo]->at;
    reference.altitude_m = median_of(own);
    const double stated_m = median_of(std::move(tagged));
    const HeightCause cause = height_cause(stated_m, reference, limit_m);
    out.push_back({.id = cause.kind == HeightCause::Kind::kUnit ? "positions.height_unit"
                                                                : "positions.heights",
                   .text = fmt::format("{} puts the photos at heights of {:.1f} m, their own GNSS "
                                       "at {:.1f} m (medians; {:.0f} m is the limit){}",
                                       sources_.tags_path->string(),
                                       stated_m,
                                       reference.altitude_m,
                                       limit_m,
                                       behind(cause.text))});
  }

  const PositionSources& sources_;
  const PositionLimits& limits_;
  Places own_;
  Places used_;
  std::vector<const GeoTag*> tag_of_ = {};
};

/// A block that no camera could have flown.
void check_extent(const PositionSources& sources, std::vector<PositionConflict>& out) {
  std::vector<GeodeticPosition> at;
  std::vector<double> latitudes;
  std::vector<double> longitudes;
  for (const PhotoMetadata& photo : sources.used) {
    if (!photo.latitude_deg || !photo.longitude_deg) continue;
    at.push_back({.latitude_deg = *photo.latitude_deg, .longitude_deg = *photo.longitude_deg});
    latitudes.push_back(*photo.latitude_deg);
    longitudes.push_back(*photo.longitude_deg);
  }
  constexpr std::size_t kLeast = 3;
  if (at.size() < kLeast) return;
  const GeodeticPosition middle{.latitude_deg = median_of(std::move(latitudes)),
                                .longitude_deg = median_of(std::move(longitudes))};
  std::vector<double> radii_m;
  for (const GeodeticPosition& place : at) radii_m.push_back(ground_distance_m(middle, place));
  const double typical_m = median_of(radii_m);
  const double largest_m = std::ranges::max(radii_m);
  constexpr double kSmallest_m = 5e-4;  // 1 mm across: below what any receiver resolves
  constexpr double kLargest_m = 5e5;    // 1000 km across: beyond what any aircraft photographs
  // Photos at exactly one place are a receiver that repeats its last fix, and told as that.
  if (largest_m > 0.0 && largest_m < kSmallest_m) {
    out.push_back({.id = "positions.extent",
                   .text = fmt::format("the {} photos lie within {} of {}: the positions look like "
                                       "degrees under a projected system",
                                       at.size(),
                                       distance_text(largest_m),
                                       place_text(middle))});
  } else if (typical_m > kLargest_m) {
    out.push_back({.id = "positions.extent",
                   .text = fmt::format("the {} photos spread over {} around {}: the positions are "
                                       "not those of one block",
                                       at.size(),
                                       distance_text(2.0 * typical_m),
                                       place_text(middle))});
  }
}

}  // namespace

bool is_error(const PositionConflict& conflict) {
  const auto kinds = finding_kinds();
  const auto kind = std::ranges::find(kinds, conflict.id, &FindingKind::id);
  HF_CHECK(kind != kinds.end());
  return kind->severity == Severity::kError;
}

std::vector<PositionConflict> compare_positions(const PositionSources& sources,
                                                const PositionLimits& limits) {
  std::vector<PositionConflict> out;
  if (sources.tags_path) TagComparison(sources, limits).compare(out);
  if (!sources.unknown_tags.empty()) {
    out.push_back({.id = "positions.unknown_photos",
                   .text = fmt::format("{}: {} of {} names are no photo that is there: {}",
                                       sources.tags_path->string(),
                                       sources.unknown_tags.size(),
                                       sources.tags.tags.size(),
                                       listed(sources.unknown_tags)),
                   .subjects = sources.unknown_tags});
  }
  check_extent(sources, out);
  if (sources.control_path) {
    std::ranges::move(compare_control(sources, limits), std::back_inserter(out));
  }
  return out;
}

}  // namespace hybridfusion
