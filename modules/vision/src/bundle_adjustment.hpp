#pragma once

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

/// GNSS of one view as it enters the adjustment.
struct GnssObservation {
  std::uint32_t view = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< East-north-up [m].
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Ones();   ///< Infinite: the component does not count.
  int flight = 0;
  double flight_time_s = 0.0;
};

/// Vertical error of the GNSS of one flight: offset + rate * time.
struct VerticalDrift {
  double offset_m = 0.0;
  double rate_mps = 0.0;
};

enum class GnssForm : std::uint8_t { kAbsolute, kDisplacement };

struct GnssTerms {
  GnssForm form = GnssForm::kAbsolute;
  std::vector<GnssObservation> observations = {};  ///< In order of time.
  bool estimate_drift = false;                     ///< Else vertical errors are independent.
  std::vector<VerticalDrift> drifts = {};          ///< Per flight; in and out.
  double loss_width = 3.0;                         ///< Cauchy, in sigmas.
};

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
};

struct AdjustmentSummary {
  int iterations = 0;
  bool converged = false;
  double initial_cost = 0.0;
  double final_cost = 0.0;
};

/// Without fixed views and GNSS the first free view is held; the scale is left to the damping.
/// Bundle adjustment, HybridFusion Eq. (1): reprojection errors (Eq. 2, here with distortion and
/// shared intrinsics under priors) plus GNSS errors, by Levenberg-Marquardt on the Schur complement
/// of the points. Deterministic (one thread).
/// @returns kDegenerate when the solver fails, kCancelled.
[[nodiscard]] Expected<AdjustmentSummary> adjust(SfmModel& model,
                                                 const AdjustmentRequest& request,
                                                 const IntrinsicsOptions& intrinsics,
                                                 const RunContext& ctx);

}  // namespace hybridfusion
