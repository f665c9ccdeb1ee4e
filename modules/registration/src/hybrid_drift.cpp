#include "drift_estimation.hpp"
#include "hybrid.hpp"

#include <hybridfusion/core/parallel.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kTimeSamples = 200000;

bool has_times(const PointCloud& lidar) {
  if (lidar.times_s.empty()) return false;
  const auto [first, last] = std::ranges::minmax(lidar.times_s);
  return std::isfinite(first) && std::isfinite(last) && last > first;
}

/// Samples in the LiDAR frame.
PointCloud sample_points(const FineInputs& inputs, const PreparedClouds& clouds) {
  PointCloud cloud;
  for (const FineSample& sample : inputs.samples) {
    cloud.points.push_back((clouds.leveled_from_lidar.inverse() * sample.point).cast<float>());
  }
  return cloud;
}

/// Each sample takes the time of the nearest of an even choice of the points.
std::vector<double> sample_times(const PointCloud& samples,
                                 const PointCloud& lidar,
                                 const RunContext& ctx) {
  const std::size_t stride = lidar.size() / kTimeSamples + 1;
  std::vector<Eigen::Vector3f> points;
  std::vector<double> times;
  for (std::size_t i = 0; i < lidar.size(); i += stride) {
    if (!lidar.points[i].allFinite()) continue;
    points.push_back(lidar.points[i]);
    times.push_back(lidar.times_s[i]);
  }
  const KdTree tree(points);
  std::vector<double> at(samples.size());
  parallel_for(ctx, at.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) at[i] = times[tree.nearest(samples.points[i]).index];
  });
  return at;
}

double path_length_m(std::span<const Eigen::Vector3d> positions) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    length_m += (positions[i] - positions[i - 1]).norm();
  }
  return length_m;
}

DriftCorrection from_leveled(DriftCorrection correction, const PreparedClouds& clouds) {
  const Eigen::Quaterniond back = clouds.leveled_from_lidar.inverse();
  for (DriftKnot& knot : correction.knots) {
    knot.pivot = back * knot.pivot;
    knot.shift_m = back * knot.shift_m;
    knot.turn_rad = back * knot.turn_rad;
  }
  return correction;
}

}  // namespace

bool scale_stands(const DriftCorrection& scaled,
                  const DriftCorrection& unscaled,
                  const DriftOptions& options) {
  constexpr double kMargin = 0.95;
  // Mean residual: 0.02 to 0.035 with true scales, 0.055 and more with those of bends.
  constexpr double kMaxResidual_m = 0.045;
  const bool bend_is_better =
      unscaled.supported &&
      unscaled.held_out_after_m < (1.0 - options.min_gain) * scaled.held_out_before_m &&
      unscaled.held_out_after_m < kMargin * scaled.held_out_after_m;
  return !bend_is_better && !scaled.supported && scaled.held_out_before_m < kMaxResidual_m;
}

Expected<DriftFinding> find_drift(FineInputs& inputs,
                                  const PreparedClouds& clouds,
                                  const PointCloud& lidar,
                                  const RegistrationInput& input,
                                  const FineResult& fine,
                                  const RegistrationOptions& options,
                                  const RunContext& ctx) {
  constexpr double kSpeed_mps = 5.0;  // of a drive whose way is not known
  const DriftAxis axis = has_times(lidar) ? DriftAxis::kTime : DriftAxis::kPath;
  const PointCloud samples = sample_points(inputs, clouds);
  std::vector<double> at;
  if (axis == DriftAxis::kTime) {
    at = sample_times(samples, lidar, ctx);
  } else {
    HF_TRY(at, drift_parameters(samples, axis, input.sensor_positions, ctx));
  }
  double length_m = path_length_m(input.sensor_positions);
  if (length_m <= 0.0 && !at.empty()) {
    const auto [first, last] = std::ranges::minmax(at);
    length_m = kSpeed_mps * (last - first);
  }
  const auto estimate_about = [&](const Sim3& vision_from_leveled) {
    return estimate_drift(
        inputs, vision_from_leveled, at, axis, length_m, options.fine, options.drift, ctx);
  };
  const Sim3 rigid{.rotation = fine.vision_from_lidar.rotation,
                   .translation = fine.vision_from_lidar.translation};
  HF_TRY(DriftEstimate estimate, estimate_about(fine.scale_supported ? fine.similarity : rigid));
  bool stands = true;
  if (fine.scale_supported) {
    HF_TRY(DriftEstimate unscaled, estimate_about(rigid));
    stands = scale_stands(estimate.correction, unscaled.correction, options.drift);
    if (!stands) estimate = std::move(unscaled);
  }
  if (estimate.correction.supported) {
    for (std::size_t i = 0; i < inputs.samples.size(); ++i) {
      Eigen::Vector3d& point = inputs.samples[i].point;
      point = corrected(estimate.correction, point, at[i]);
    }
  }
  return DriftFinding{.correction = from_leveled(estimate.correction, clouds),
                      .rigid = estimate.rigid,
                      .scale_stands = stands};
}

}  // namespace hybridfusion
