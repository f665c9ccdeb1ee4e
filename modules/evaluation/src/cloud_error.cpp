#include "statistics.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/evaluation/cloud_error.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kGrain = 4096;

DistanceStatistics statistics_of(const std::vector<float>& distances_m) {
  const double sum = std::accumulate(distances_m.begin(), distances_m.end(), 0.0);
  const auto count = static_cast<double>(distances_m.size());
  DistanceStatistics result{.num_points = distances_m.size(),
                            .mean_m = distances_m.empty() ? std::nan("") : sum / count,
                            .median_m = quantile(distances_m, 0.5),
                            .percentile95_m = quantile(distances_m, 0.95)};
  for (std::size_t k = 0; k < kStrayDistances_m.size(); ++k) {
    const auto beyond =
        std::ranges::count_if(distances_m, [&](float d) { return d > kStrayDistances_m[k]; });
    result.share_beyond[k] =
        distances_m.empty() ? std::nan("") : static_cast<double>(beyond) / count;
  }
  return result;
}

std::vector<Eigen::Vector3f> finite(std::span<const Eigen::Vector3f> points) {
  std::vector<Eigen::Vector3f> kept;
  std::ranges::copy_if(
      points, std::back_inserter(kept), [](const Eigen::Vector3f& p) { return p.allFinite(); });
  return kept;
}

Expected<void> check_labels(std::span<const std::uint8_t> labels) {
  const auto bad = std::ranges::find_if(labels, [](auto l) { return l >= kNumSurfaceLabels; });
  if (bad == labels.end()) return {};
  return fail(ErrorCode::kInvalidOptions,
              fmt::format("surface label {} is not one of 0 ground, 1 building, 2 vegetation, 3 "
                          "other",
                          *bad));
}

}  // namespace

Expected<CloudAccuracy> cloud_accuracy(std::span<const Eigen::Vector3f> points_in_truth,
                                       const SurfaceDistance& surface,
                                       std::span<const std::uint8_t> triangle_labels,
                                       const RunContext& ctx) {
  if (const auto labels = check_labels(triangle_labels); !labels) {
    return std::unexpected(labels.error());
  }
  const std::vector<Eigen::Vector3f> points = finite(points_in_truth);
  if (points.empty()) return fail(ErrorCode::kInsufficient, "the cloud has no finite point");
  std::vector<SurfacePoint> nearest(points.size());
  parallel_for(ctx, points.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (ctx.stopped()) return;
    for (std::size_t i = begin; i < end; ++i) nearest[i] = surface.nearest(points[i]);
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while measuring distances");
  std::vector<float> all;
  std::vector<float> hard;
  std::array<std::vector<float>, kNumSurfaceLabels> by_label;
  for (const SurfacePoint& point : nearest) {
    all.push_back(point.distance_m);
    if (triangle_labels.empty()) continue;
    if (point.triangle >= triangle_labels.size()) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("{} labels for a mesh with at least {} triangles",
                              triangle_labels.size(),
                              point.triangle + 1));
    }
    const std::uint8_t label = triangle_labels[point.triangle];
    by_label[label].push_back(point.distance_m);
    if (label <= std::to_underlying(SurfaceLabel::kBuilding)) hard.push_back(point.distance_m);
  }
  CloudAccuracy result{.all = statistics_of(all), .hard = statistics_of(hard)};
  std::ranges::transform(by_label, result.by_label.begin(), statistics_of);
  return result;
}

Expected<CloudCompleteness> cloud_completeness(std::span<const Eigen::Vector3f> samples_in_truth,
                                               std::span<const Eigen::Vector3f> points_in_truth,
                                               const RunContext& ctx) {
  const std::vector<Eigen::Vector3f> points = finite(points_in_truth);
  if (samples_in_truth.empty() || points.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("completeness needs samples and points, got {} and {}",
                            samples_in_truth.size(),
                            points.size()));
  }
  const KdTree tree(points);
  std::vector<float> squared_m2(samples_in_truth.size());
  parallel_for(ctx, samples_in_truth.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    if (ctx.stopped()) return;
    for (std::size_t i = begin; i < end; ++i) {
      squared_m2[i] = tree.nearest(samples_in_truth[i]).squared_distance_m2;
    }
  });
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while measuring completeness");
  CloudCompleteness result{.num_samples = samples_in_truth.size()};
  for (std::size_t k = 0; k < kCompletenessDistances_m.size(); ++k) {
    const double limit_m2 = kCompletenessDistances_m[k] * kCompletenessDistances_m[k];
    const auto covered =
        std::ranges::count_if(squared_m2, [limit_m2](float d) { return d <= limit_m2; });
    result.share[k] = static_cast<double>(covered) / static_cast<double>(squared_m2.size());
  }
  return result;
}

}  // namespace hybridfusion
