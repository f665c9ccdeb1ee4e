#include "hybrid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinGroundCells = 50;

/// Ground alignment and one more refinement with the tilt that it found.
void level_place(OutlinePlace& place,
                 const PreparedClouds& clouds,
                 const RegistrationOptions& options) {
  for (int round = 0; round < 2; ++round) {
    const auto ground =
        align_ground(clouds.maps, clouds.lidar_maps, place.vision_from_leveled, kMinGroundCells);
    if (!ground) return;
    place.vision_from_leveled = ground->vision_from_lidar;
    place.ground_inliers = ground->num_inliers;
    if (round == 1) break;
    const Eigen::Matrix3d tilt = split_heading(place.vision_from_leveled.rotation).tilt;
    const PlanarPattern pattern = make_pattern(clouds.lidar_maps, tilt);
    const PlanarPose start = planar_of(place.vision_from_leveled, pattern, place.planar.overhang_m);
    place.planar = refine_pose(clouds.maps, pattern, start, 0.5, options.outline);
    place.vision_from_leveled =
        lift(place.planar, pattern, tilt, place.vision_from_leveled.translation.z());
  }
}

/// Squared Mahalanobis distance of a place from the coarse pose in x, y and heading.
double prior_distance(const Rigid3& vision_from_lidar,
                      const Rigid3& initial,
                      const PoseCovariance& covariance) {
  const Rigid3 error = initial.inverse() * vision_from_lidar;
  const Eigen::AngleAxisd turn(error.rotation);
  const Eigen::Vector3d gap(
      error.translation.x(), error.translation.y(), turn.angle() * turn.axis().z());
  Eigen::Matrix3d marginal;
  const std::array<Eigen::Index, 3> kept{0, 1, 5};
  for (Eigen::Index r = 0; r < 3; ++r) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      marginal(r, c) =
          covariance(kept[static_cast<std::size_t>(r)], kept[static_cast<std::size_t>(c)]);
    }
  }
  return gap.dot(marginal.ldlt().solve(gap));
}

/// What the exhaustive search needs, at twice the cell. `coarser` may be `maps`.
void halve(const VisionMaps& maps, VisionMaps& coarser) {
  Raster edge = halved(maps.edge);
  Raster interior = halved(maps.interior);
  coarser.edge = std::move(edge);
  coarser.interior = std::move(interior);
}

}  // namespace

std::vector<OutlinePlace> distinct_places(std::vector<OutlinePlace> places,
                                          const OutlineOptions& options) {
  std::ranges::stable_sort(places, std::ranges::greater{}, &OutlinePlace::score);
  std::vector<OutlinePlace> distinct;
  for (const OutlinePlace& place : places) {
    const bool is_new = std::ranges::none_of(distinct, [&](const OutlinePlace& other) {
      return same_peak(place.planar, other.planar, options);
    });
    if (is_new) distinct.push_back(place);
  }
  return distinct;
}

Expected<OutlinePlaces> find_places(const PreparedClouds& clouds,
                                    const RegistrationInput& input,
                                    const RegistrationOptions& options,
                                    const RunContext& ctx,
                                    int halvings) {
  const PlanarPattern pattern = make_pattern(clouds.lidar_maps, Eigen::Matrix3d::Identity());
  if (pattern.facades.empty()) {
    return fail(ErrorCode::kDegenerate,
                "the LiDAR cloud shows no facades (an open field?): nothing fixes the position");
  }
  const PlanarPose coarse = planar_of(clouds.vision_from_leveled_initial, pattern, 0.0);
  SearchWindow window{.yaw_rad = coarse.yaw_rad, .max_yaw_rad = options.max_yaw_rad};
  if (input.vision_from_lidar_initial) {
    window.position = coarse.position;
    window.max_offset_m = options.max_offset_m;
  }
  VisionMaps coarser;
  for (int k = 0; k < halvings; ++k) halve(k == 0 ? clouds.search_maps : coarser, coarser);
  const VisionMaps& maps = halvings > 0 ? coarser : clouds.search_maps;
  HF_TRY(const OutlineSearch search, search_outlines(maps, pattern, window, options.outline, ctx));
  if (search.peaks.empty()) {
    return fail(ErrorCode::kDegenerate,
                "no position inside the search window brings a facade onto a roof rim; the clouds "
                "do not overlap there");
  }
  std::vector<OutlinePlace> places;
  for (PlanarPose peak : search.peaks) {
    peak.overhang_m = 0.25;
    OutlinePlace place;
    const OutlineOptions& outline = options.outline;
    if (halvings > 0) {
      // From a coarse raster the fine rims, blurred by half a metre, are out of reach.
      peak = refine_pose(clouds.search_maps, pattern, peak, maps.edge.grid.cell_m, outline);
    }
    place.planar = refine_pose(clouds.maps, pattern, peak, outline.search_cell_m, outline);
    const double height_m =
        clouds.vision_ground.height_at(place.planar.position.x(), place.planar.position.y()) -
        clouds.lidar_ground.height_at(pattern.centre.x(), pattern.centre.y());
    place.vision_from_leveled = lift(place.planar, pattern, Eigen::Matrix3d::Identity(), height_m);
    level_place(place, clouds, options);
    place.score = place.planar.score;
    place.evidence = judge_pose(
        clouds.maps, clouds.lidar_maps, place.vision_from_leveled, place.planar.overhang_m);
    places.push_back(place);
  }
  return OutlinePlaces{.places = distinct_places(std::move(places), options.outline),
                       .yaw_scores = search.yaw_scores};
}

void prefer_by_prior(const PreparedClouds& clouds,
                     const RegistrationInput& input,
                     double max_peak_ratio,
                     OutlinePlaces& found) {
  std::vector<OutlinePlace>& places = found.places;
  if (!input.vision_from_lidar_initial || !input.initial_covariance) return;
  const auto is_excluded = [&](const OutlinePlace& place) {
    const double squared = prior_distance(from_leveled(place.vision_from_leveled, clouds),
                                          *input.vision_from_lidar_initial,
                                          *input.initial_covariance);
    return squared > 25.0;
  };
  const auto first = std::ranges::find_if_not(places, is_excluded);
  if (first == places.end() || first->score < max_peak_ratio * places.front().score) return;
  found.used_prior = std::erase_if(places, is_excluded) > 0;
}

RidgeTest test_ridge(const PreparedClouds& clouds,
                     const OutlinePlace& place,
                     const OutlineOptions& options) {
  constexpr double kStep_m = 3.0;
  constexpr int kDirections = 16;
  const PlanarPattern pattern =
      make_pattern(clouds.lidar_maps, split_heading(place.vision_from_leveled.rotation).tilt);
  RidgeTest test;
  for (int k = 0; k < kDirections; ++k) {
    const double bearing = 2.0 * std::numbers::pi * k / kDirections;
    PlanarPose beside = place.planar;
    beside.position += kStep_m * Eigen::Vector2d(std::cos(bearing), std::sin(bearing));
    const double score = score_of(clouds.maps, pattern, beside, options.free_penalty);
    if (place.score > 0.0 && score / place.score > test.ratio) {
      test = {.ratio = score / place.score, .bearing_rad = bearing};
    }
  }
  return test;
}

}  // namespace hybridfusion
