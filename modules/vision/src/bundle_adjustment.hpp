#pragma once

#include "control_target.hpp"
#include "gnss_terms.hpp"
#include "sfm_model.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

enum class CalibrationLevel : std::uint8_t {
  kFixed,   ///< No intrinsics change.
  kRadial,  ///< f, k1, k2.
  kFull,    ///< All.
};

struct AdjustmentRequest {
  std::vector<std::uint32_t> free_views = {};
  std::vector<std::uint32_t> fixed_views = {};
  std::vector<std::uint32_t> tracks = {};  ///< Only active elements in free and fixed views count.
  CalibrationLevel calibration = CalibrationLevel::kFixed;
  double sigma_px = 1.0;  ///< Standard deviation of a pixel coordinate, reduced photo.
  double loss_width_px = 1.5;
  int max_iterations = 50;
  GnssTerms* gnss = nullptr;
  std::span<const ControlTarget> control = {};
  bool covariance = false;  ///< Fill SfmModel::pose_covariance.
};

struct AdjustmentSummary {
  int iterations = 0;
  bool converged = false;
  double initial_cost = 0.0;
  double final_cost = 0.0;
};

/// Without fixed views, GNSS and control the first free view is held; the scale is left to the
/// damping. Bundle adjustment, HybridFusion Eq. (1): reprojection errors (Eq. 2, here with
/// distortion and shared intrinsics under priors) plus GNSS errors, by Levenberg-Marquardt on the
/// Schur complement of the points. Deterministic (one thread).
/// @returns kDegenerate when the solver fails, kCancelled.
[[nodiscard]] Expected<AdjustmentSummary> adjust(SfmModel& model,
                                                 const AdjustmentRequest& request,
                                                 const IntrinsicsOptions& intrinsics,
                                                 const RunContext& ctx);

}  // namespace hybridfusion
