#pragma once

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/evaluation/cloud_error.hpp>

#include <array>
#include <cstddef>
#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// How a cloud lies on flat pieces of the true surface, half a metre around samples.
struct SheetError {
  std::size_t num_patches = 0;
  double thickness_m = 0.0;  ///< Median over the patches of the span from 5 to 95 % of the heights.
  double bias_m = 0.0;       ///< Median over the patches of the median height's absolute value.
};

/// @param samples_in_truth  Surface samples [m] with unit `normals`; patches are taken where those
/// within half a metre lie in one plane to 5 mm. At most 3000, evenly over the samples.
/// @param points_in_truth   The cloud; a patch counts its points within 0.3 m of the plane.
/// @returns kInsufficient when no flat patch has ten points, kInvalidOptions when the normals are
/// not as many as the samples, kCancelled.
[[nodiscard]] Expected<SheetError> sheet_error(std::span<const Eigen::Vector3f> samples_in_truth,
                                               std::span<const Eigen::Vector3f> normals,
                                               std::span<const Eigen::Vector3f> points_in_truth,
                                               const RunContext& ctx = {});

/// Median distance to the true surface in units of the points' own deviations: 0.67 when normally
/// distributed errors are as large as stated. NaN without points.
struct SigmaCalibration {
  double hard = 0.0;  ///< Ground and buildings.
  std::array<double, kNumSurfaceLabels> by_label = {};
};

/// @param sigmas_m  One a point; points without a positive one do not count.
/// @pre as many sigmas as points; one valid label a triangle
[[nodiscard]] SigmaCalibration sigma_calibration(std::span<const Eigen::Vector3f> points_in_truth,
                                                 std::span<const float> sigmas_m,
                                                 const SurfaceDistance& surface,
                                                 std::span<const std::uint8_t> triangle_labels,
                                                 const RunContext& ctx = {});

}  // namespace hybridfusion
