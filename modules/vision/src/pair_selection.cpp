#include "pair_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace hybridfusion {
namespace {

constexpr int kUnplacedTemporalFactor = 7;  // some 20 photos each way

using Places = std::vector<std::optional<Eigen::Vector2d>>;

void insert(std::set<PhotoPair>& pairs, std::size_t a, std::size_t b) {
  if (a == b) return;
  pairs.insert({.first = static_cast<std::uint32_t>(std::min(a, b)),
                .second = static_cast<std::uint32_t>(std::max(a, b))});
}

/// Where the optical axis meets the ground, if the metadata tells.
std::optional<Eigen::Vector2d> view_centre(const PhotoMetadata& photo, const PhotoFix& fix) {
  if (!fix.position_in_enu || !photo.gimbal || !photo.relative_altitude_m) return std::nullopt;
  const double pitch = photo.gimbal->pitch_deg * std::numbers::pi / 180.0;
  const double yaw = photo.gimbal->yaw_deg * std::numbers::pi / 180.0;
  const double height_m = *photo.relative_altitude_m;
  // Beyond 60 degrees from nadir the centre runs away to the horizon: hold it there.
  constexpr double kMaxReach = 1.75;
  if (height_m < 2.0 || pitch > 0.0) return std::nullopt;
  const double reach_m = height_m * std::min(kMaxReach, 1.0 / std::tan(std::max(-pitch, 1e-3)));
  return fix.position_in_enu->head<2>() +
         std::max(0.0, reach_m) * Eigen::Vector2d(std::sin(yaw), std::cos(yaw));
}

void add_nearest(std::set<PhotoPair>& pairs, const Places& places, int count) {
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    others.clear();
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (j != i && places[j]) others.emplace_back((*places[j] - *places[i]).squaredNorm(), j);
    }
    const auto kept = std::min(others.size(), static_cast<std::size_t>(count));
    std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(kept));
    for (std::size_t k = 0; k < kept; ++k) insert(pairs, i, others[k].second);
  }
}

}  // namespace

std::vector<PhotoPair> select_pairs(std::span<const PhotoMetadata> photos,
                                    const GnssIngest& gnss,
                                    const PairOptions& options) {
  const std::size_t n = photos.size();
  std::set<PhotoPair> pairs;
  if (n <= static_cast<std::size_t>(options.exhaustive_photos)) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) insert(pairs, i, j);
    }
    return {pairs.begin(), pairs.end()};
  }
  Places positions(n);
  Places centres(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (gnss.fixes[i].position_in_enu) positions[i] = gnss.fixes[i].position_in_enu->head<2>();
    centres[i] = view_centre(photos[i], gnss.fixes[i]);
  }
  const bool all_centres =
      std::ranges::all_of(centres, [](const auto& c) { return c.has_value(); });
  add_nearest(pairs, all_centres ? centres : positions, options.spatial_neighbors);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = gnss.by_time[k];
    const bool placed = positions[i].has_value();
    const auto reach = static_cast<std::size_t>(options.temporal_neighbors *
                                                (placed ? 1 : kUnplacedTemporalFactor));
    for (std::size_t m = k + 1; m < std::min(n, k + 1 + reach); ++m) {
      insert(pairs, i, gnss.by_time[m]);
    }
    for (std::size_t m = k - std::min(k, reach); m < k && !placed; ++m) {
      insert(pairs, i, gnss.by_time[m]);
    }
    if (!placed && n <= kAllPairsPhotos) {
      for (std::size_t j = 0; j < n; ++j) insert(pairs, i, j);
    }
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace hybridfusion
