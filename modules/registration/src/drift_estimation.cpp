#include "drift_estimation.hpp"

#include "drift_problem.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::size_t kMinPairs = 1000;

/// The rigid motion in the correction, over the samples.
Expected<Rigid3> rigid_part(const FineInputs& inputs,
                            std::span<const double> at,
                            const DriftCorrection& correction) {
  std::vector<Eigen::Vector3d> from;
  std::vector<Eigen::Vector3d> to;
  for (std::size_t i = 0; i < inputs.samples.size(); ++i) {
    from.push_back(inputs.samples[i].point);
    to.push_back(corrected(correction, from.back(), at[i]));
  }
  return fit_rigid3(to, from);
}

/// Takes `rigid` out of the correction, to first order: a turn of a degree leaves centimetres of
/// second order at 100 m, and corrections turn by tenths.
void take_out(const Rigid3& rigid, DriftCorrection& correction) {
  const Eigen::AngleAxisd turn(rigid.rotation);
  for (DriftKnot& knot : correction.knots) {
    knot.shift_m -= rigid * knot.pivot - knot.pivot;
    knot.turn_rad -= turn.angle() * turn.axis();
    correction.size_m = std::max(correction.size_m, knot.shift_m.norm());
  }
}

}  // namespace

Expected<DriftEstimate> estimate_drift(FineInputs& inputs,
                                       const Sim3& vision_from_lidar,
                                       std::span<const double> at,
                                       DriftAxis axis,
                                       double length_m,
                                       const FineOptions& fine,
                                       const DriftOptions& options,
                                       const RunContext& ctx) {
  HF_CHECK(at.size() == inputs.samples.size());
  if (at.size() < kMinPairs || !(std::ranges::max(at) > std::ranges::min(at))) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("{} samples along the drive, at least {} at different places are "
                            "needed for a drift",
                            at.size(),
                            kMinPairs));
  }
  DriftProblem problem(inputs, vision_from_lidar, at, fine, ctx);
  const int intervals = std::clamp(
      static_cast<int>(std::lround(length_m / options.knot_distance_m)), 2, options.max_knots - 1);
  problem.lay_knots(intervals);
  const auto fit = [&](bool with_held_out) {
    for (const double gate_m : {1.0, 0.7, 0.5, 0.5, 0.4, 0.4}) {
      if (!ctx.stopped()) problem.solve(gate_m, with_held_out);
    }
  };
  DriftEstimate estimate;
  DriftCorrection& correction = estimate.correction;
  correction.axis = axis;
  correction.held_out_before_m = problem.judge();
  fit(false);
  correction.held_out_after_m = problem.judge();
  const bool is_better =
      correction.held_out_after_m < (1.0 - options.min_gain) * correction.held_out_before_m;
  if (is_better) fit(true);
  if (ctx.stopped()) return fail(ErrorCode::kCancelled, "stopped while estimating the drift");
  correction.knots = problem.knots();
  HF_TRY(estimate.rigid, rigid_part(inputs, at, correction));
  take_out(estimate.rigid, correction);
  correction.supported = is_better && correction.size_m >= options.min_size_m &&
                         correction.size_m <= options.max_size_m;
  return estimate;
}

}  // namespace hybridfusion
