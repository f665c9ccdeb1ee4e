#include "doctor_checks.hpp"

#include <hybridfusion/vision/gnss_ingest.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr double kDiagonal35_mm = 43.266615;
constexpr double kGuessedFocal = 1.2;       // of the longer side
constexpr double kUnknownHeight_m = 500.0;  // generous, so that only certain gaps are reported
constexpr double kMinOverlap = 0.5;
constexpr double kMaxTilt_rad = 70.0 * std::numbers::pi / 180.0;

/// The part of the ground a photo sees, as a circle.
struct Footprint {
  std::size_t photo = 0;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;  ///< Reaches to the corners.
  double short_side_m = 0.0;
};

double focal_px_of(const PhotoMetadata& photo) {
  if (photo.calibrated_focal_px) return *photo.calibrated_focal_px;
  if (photo.focal_35mm) {
    return *photo.focal_35mm / kDiagonal35_mm * std::hypot(photo.width, photo.height);
  }
  return kGuessedFocal * std::max(photo.width, photo.height);
}

std::optional<double> height_above_ground(const PhotoMetadata& photo,
                                          std::optional<double> ground_altitude_m) {
  if (photo.relative_altitude_m && *photo.relative_altitude_m > 1.0)
    return photo.relative_altitude_m;
  const auto altitude = known_altitude_m(photo);
  if (!ground_altitude_m || !altitude) return std::nullopt;
  // A receiver's height is off by metres; below 10 m it says nothing.
  return std::max(10.0, *altitude - *ground_altitude_m);
}

Footprint footprint_of(const PhotoMetadata& photo,
                       const Eigen::Vector2d& position,
                       double height_m) {
  const double focal_px = focal_px_of(photo);
  Footprint footprint{.center_m = position};
  double tilt = 0.0;
  if (photo.gimbal) {
    tilt =
        std::clamp((90.0 + photo.gimbal->pitch_deg) * std::numbers::pi / 180.0, 0.0, kMaxTilt_rad);
    const double yaw = photo.gimbal->yaw_deg * std::numbers::pi / 180.0;
    footprint.center_m += height_m * std::tan(tilt) * Eigen::Vector2d(std::sin(yaw), std::cos(yaw));
  }
  const double distance_m = height_m / std::cos(tilt);
  footprint.radius_m = distance_m * 0.5 * std::hypot(photo.width, photo.height) / focal_px;
  footprint.short_side_m = distance_m * std::min(photo.width, photo.height) / focal_px;
  return footprint;
}

/// Component of each footprint in the graph of those that touch.
std::vector<std::size_t> components(const std::vector<Footprint>& footprints) {
  std::vector<std::size_t> root(footprints.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&root](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double reach_m = footprints[i].radius_m + footprints[j].radius_m;
      if ((footprints[i].center_m - footprints[j].center_m).squaredNorm() < reach_m * reach_m) {
        root[find(i)] = find(j);
      }
    }
  }
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = find(i);
  return root;
}

/// Median over the photos of the share they have in common with their nearest neighbour.
double median_overlap(const std::vector<Footprint>& footprints) {
  std::vector<double> overlaps;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < footprints.size(); ++j) {
      if (i == j) continue;
      nearest_m = std::min(nearest_m, (footprints[i].center_m - footprints[j].center_m).norm());
    }
    overlaps.push_back(std::max(0.0, 1.0 - nearest_m / footprints[i].short_side_m));
  }
  const auto middle = overlaps.begin() + static_cast<std::ptrdiff_t>(overlaps.size() / 2);
  std::ranges::nth_element(overlaps, middle);
  return *middle;
}

void report_components(const std::vector<Footprint>& footprints,
                       std::span<const PhotoMetadata> photos,
                       Diagnosis& diagnosis) {
  const std::vector<std::size_t> root = components(footprints);
  std::vector<std::size_t> sizes(root.size(), 0);
  for (const std::size_t r : root) ++sizes[r];
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
  std::vector<std::string> outside;
  for (std::size_t i = 0; i < root.size(); ++i) {
    if (root[i] != largest) outside.push_back(photos[footprints[i].photo].name);
  }
  if (outside.empty()) return;
  diagnosis.findings.add(2 * sizes[largest] < root.size() ? "photos.no_overlap" : "photos.islands",
                         fmt::format("only {} of {} photos hang together; outside: {}",
                                     sizes[largest],
                                     root.size(),
                                     listed(outside)),
                         outside);
}

}  // namespace

void check_overlap(std::span<const PhotoMetadata> photos,
                   std::optional<double> ground_altitude_m,
                   const GnssOptions& options,
                   Diagnosis& diagnosis) {
  const auto ingest = ingest_gnss(photos, options);
  if (!ingest) return;  // the positions are no good, which is a finding of its own
  std::vector<Footprint> footprints;
  std::size_t known_heights = 0;
  for (std::size_t i = 0; i < photos.size(); ++i) {
    if (!ingest->fixes[i].position_in_enu) continue;
    const auto height_m = height_above_ground(photos[i], ground_altitude_m);
    if (height_m) ++known_heights;
    footprints.push_back(footprint_of(photos[i],
                                      ingest->fixes[i].position_in_enu->head<2>(),
                                      height_m.value_or(kUnknownHeight_m)));
    footprints.back().photo = i;
  }
  if (footprints.size() < 2) return;
  report_components(footprints, photos, diagnosis);
  if (known_heights < footprints.size()) {
    diagnosis.facts.emplace_back(
        "height of the flight over the ground unknown: overlap not judged");
    return;
  }
  const double overlap = median_overlap(footprints);
  diagnosis.facts.push_back(
      fmt::format("neighbouring photos share {:.0f} % of their view (median)", 100.0 * overlap));
  if (overlap < kMinOverlap) {
    diagnosis.findings.add(
        "photos.low_overlap",
        fmt::format("neighbouring photos share {:.0f} % of their view (median)", 100.0 * overlap));
  }
}

}  // namespace hybridfusion
