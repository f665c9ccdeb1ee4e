#include "photo_places.hpp"
#include "position_conflicts.hpp"

#include <hybridfusion/io/coordinate_cause.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Differences of placed photos from their own positions, and what may be.
struct Gaps {
  std::vector<double> horizontal_m = {};
  std::vector<double> vertical_m = {};
  std::vector<double> horizontal_limit_m = {};
  std::vector<double> vertical_limit_m = {};
  std::vector<double> placed_m = {};  ///< Heights above the ellipsoid.
  std::vector<double> gnss_m = {};
  std::vector<std::string> beyond = {};
};

Gaps gaps_of(const Reconstruction& reconstruction, const PositionLimits& limits) {
  Gaps gaps;
  for (const View& view : reconstruction.views) {
    if (!view.enu_from_camera || !view.gnss_in_enu || !view.gnss_sigma_m) continue;
    const Eigen::Vector3d placed = view.enu_from_camera->translation;
    const Eigen::Vector3d gap = placed - *view.gnss_in_enu;
    // What RTK states is the deviation from its base, not from the control's system.
    const double horizontal_sigma_m =
        std::max(view.gnss_sigma_m->head<2>().maxCoeff(), limits.gnss.default_sigma_m);
    const double vertical_sigma_m =
        std::max(view.gnss_sigma_m->z(), limits.gnss.min_sigma_vertical_m);
    gaps.horizontal_m.push_back(gap.head<2>().norm());
    gaps.vertical_m.push_back(gap.z());
    gaps.horizontal_limit_m.push_back(limits.max_sigma * horizontal_sigma_m);
    gaps.vertical_limit_m.push_back(limits.max_sigma * vertical_sigma_m);
    gaps.placed_m.push_back(geodetic_from_enu(reconstruction.origin, placed).altitude_m);
    gaps.gnss_m.push_back(geodetic_from_enu(reconstruction.origin, *view.gnss_in_enu).altitude_m);
    if (gaps.horizontal_m.back() > gaps.horizontal_limit_m.back()) gaps.beyond.push_back(view.name);
  }
  return gaps;
}

const View& first_of(const Reconstruction& reconstruction, const std::string& name) {
  return *std::ranges::find(reconstruction.views, name, &View::name);
}

PositionConflict apart(const Reconstruction& reconstruction,
                       const std::string& placed_by,
                       const Gaps& gaps) {
  const View& view = first_of(reconstruction, gaps.beyond.front());
  const auto placed = geodetic_from_enu(reconstruction.origin, view.enu_from_camera->translation);
  const auto gnss = geodetic_from_enu(reconstruction.origin, *view.gnss_in_enu);
  const double gap_m = median_of(gaps.horizontal_m);
  const double limit_m = median_of(gaps.horizontal_limit_m);
  const std::string cause =
      horizontal_cause({.position = placed}, gnss, std::max(limit_m, 0.01 * gap_m));
  return {.id = "positions.placement",
          .text = fmt::format("{} puts {} at {}, its GNSS at {}: {} apart in the median, {} is the "
                              "limit; so {} of {} photos{}",
                              placed_by,
                              view.name,
                              place_text(placed),
                              place_text(gnss),
                              distance_text(gap_m),
                              distance_text(limit_m),
                              gaps.beyond.size(),
                              gaps.horizontal_m.size(),
                              cause.empty() ? std::string() : ": " + cause),
          .subjects = gaps.beyond};
}

std::vector<PositionConflict> compare_heights(const Reconstruction& reconstruction,
                                              const PlacedBy& placed_by,
                                              const Gaps& gaps) {
  const double gap_m = median_of(gaps.vertical_m);
  const double limit_m = median_of(gaps.vertical_limit_m);
  const double placed_m = median_of(gaps.placed_m);
  const double stated_m = placed_by.height_m.value_or(placed_m);
  GeodeticPosition reference = reconstruction.origin;
  reference.altitude_m = stated_m - gap_m;
  HeightCause cause = height_cause(stated_m, reference, limit_m);
  // Where the unit was a guess, it is given up for one that fits clearly better.
  constexpr double kClearly = 0.4;
  if (placed_by.unit_assumed && std::abs(gap_m) > kClearly * limit_m) {
    const HeightCause other = height_cause(stated_m, reference, 0.5 * kClearly * limit_m);
    if (other.kind == HeightCause::Kind::kUnit) cause = other;
  }
  const bool unit = cause.kind == HeightCause::Kind::kUnit;
  if (!unit && std::abs(gap_m) <= limit_m) return {};
  return {{.id = unit ? "positions.height_unit" : "positions.heights",
           .text = fmt::format("{} puts the photos at heights of {:.1f} m, their GNSS at {:.1f} m "
                               "(medians; {:.0f} m is the limit){}",
                               placed_by.what,
                               placed_m,
                               median_of(gaps.gnss_m),
                               limit_m,
                               cause.text.empty() ? std::string() : ": " + cause.text)}};
}

}  // namespace

std::vector<PositionConflict> compare_placement(const Reconstruction& reconstruction,
                                                const PlacedBy& placed_by,
                                                const PositionLimits& limits) {
  const Gaps gaps = gaps_of(reconstruction, limits);
  if (gaps.horizontal_m.empty()) return {};
  if (2 * gaps.beyond.size() > gaps.horizontal_m.size()) {
    return {apart(reconstruction, placed_by.what, gaps)};
  }
  return compare_heights(reconstruction, placed_by, gaps);
}

}  // namespace hybridfusion
