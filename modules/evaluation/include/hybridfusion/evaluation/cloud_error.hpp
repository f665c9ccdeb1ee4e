#pragma once

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/evaluation/surface_distance.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Surface kinds of a data set with truth.
enum class SurfaceLabel : std::uint8_t { kGround = 0, kBuilding = 1, kVegetation = 2, kOther = 3 };
inline constexpr std::size_t kNumSurfaceLabels = 4;

/// Distances beyond which the shares of a cloud are counted: stray points, and points in the sky.
inline constexpr std::array<double, 2> kStrayDistances_m = {0.5, 3.0};

struct DistanceStatistics {
  std::size_t num_points = 0;
  double mean_m = 0.0;  ///< All three NaN without points.
  double median_m = 0.0;
  double percentile95_m = 0.0;
  std::array<double, kStrayDistances_m.size()> share_beyond = {};
};

/// Distances of a cloud to the true surface, by the kind of the nearest surface.
struct CloudAccuracy {
  DistanceStatistics all = {};
  DistanceStatistics hard = {};  ///< Ground and buildings: what does not move and has no leaves.
  std::array<DistanceStatistics, kNumSurfaceLabels> by_label = {};
};

/// @param points_in_truth  The cloud in the frame of the mesh [m].
/// @param triangle_labels  One SurfaceLabel a triangle, or empty: then only `all` is filled.
/// @returns kInsufficient without finite points, kInvalidOptions for another number of labels or
/// an unknown label, kCancelled.
[[nodiscard]] Expected<CloudAccuracy> cloud_accuracy(
    std::span<const Eigen::Vector3f> points_in_truth,
    const SurfaceDistance& surface,
    std::span<const std::uint8_t> triangle_labels,
    const RunContext& ctx = {});

inline constexpr std::array<double, 3> kCompletenessDistances_m = {0.1, 0.2, 0.5};

/// Share of surface samples that have a point of the cloud within each distance.
struct CloudCompleteness {
  std::size_t num_samples = 0;
  std::array<double, kCompletenessDistances_m.size()> share = {};
};

/// @param samples_in_truth  Surface samples that the source could see.
/// @returns kInsufficient without samples or without finite points, kCancelled.
[[nodiscard]] Expected<CloudCompleteness> cloud_completeness(
    std::span<const Eigen::Vector3f> samples_in_truth,
    std::span<const Eigen::Vector3f> points_in_truth,
    const RunContext& ctx = {});

}  // namespace hybridfusion
