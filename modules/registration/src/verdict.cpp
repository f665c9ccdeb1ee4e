#include "verdict.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// 0 at `bad`, 1 at `good`, linear between; either may be the larger one.
double ramp(double value, double bad, double good) {
  return std::clamp((value - bad) / (good - bad), 0.0, 1.0);
}

double peak_ratio(const Evidence& e) {
  return e.best_score > 0.0 ? std::max(0.0, e.second_score) / e.best_score : 1.0;
}

/// One piece of evidence: how much of the confidence it leaves, and what to say when it fails.
struct Factor {
  double value = 1.0;
  std::string complaint = {};
};

/// Limits come from the options; the comfortable values beside them are those that every right pose
/// of the calibration scenes reached (synthetic blocks and crops of 12 to 60 m radius).
std::vector<Factor> weigh_surfaces(const PoseEvidence& e, const VerdictOptions& o) {
  return {
      {ramp(e.facade_share, o.min_facade_share, o.min_facade_share + 0.25),
       fmt::format("only {:.2f} of the facades lie on roof rims (limit {:.2f})",
                   e.facade_share,
                   o.min_facade_share)},
      {ramp(e.facade_on_ground, o.max_facade_on_ground, 0.3 * o.max_facade_on_ground),
       fmt::format("{:.2f} of the facades stand on open ground of the vision cloud (limit {:.2f})",
                   e.facade_on_ground,
                   o.max_facade_on_ground)},
      {ramp(e.ground_share, o.min_ground_share, 0.5 + 0.5 * o.min_ground_share),
       fmt::format("only {:.2f} of the LiDAR ground lies within 0.2 m of the vision ground (limit "
                   "{:.2f})",
                   e.ground_share,
                   o.min_ground_share)},
      {ramp(e.free_violations, o.max_free_violations, 0.3 * o.max_free_violations),
       fmt::format("{:.2f} of the LiDAR ground lies inside vision buildings (limit {:.2f})",
                   e.free_violations,
                   o.max_free_violations)},
  };
}

double product(const std::vector<Factor>& factors) {
  double confidence = 1.0;
  for (const Factor& factor : factors) confidence *= factor.value;
  return confidence;
}

/// What is to be said when the product is too small.
std::string weakest(const std::vector<Factor>& factors, double confidence, double min_confidence) {
  return fmt::format("the evidence leaves a confidence of {:.2f} (at least {:.2f} needed): {}",
                     confidence,
                     min_confidence,
                     std::ranges::min_element(factors, {}, &Factor::value)->complaint);
}

/// What facades on surfaces leave. Of LiDAR crops of 12 m radius right poses have 0.56 to 0.86,
/// wrong ones at most 0.60.
double support_factor(const Evidence& e, const VerdictOptions& o) {
  return ramp(e.facade_support, o.min_facade_support, o.min_facade_support + 0.1);
}

/// Surfaces that lead away within the peak of the outlines are believed where facades support it.
double surface_factor(const Evidence& e, const VerdictOptions& o) {
  if (e.fine_agrees) return 1.0;
  if (e.fine_stays) return support_factor(e, o);
  return e.has_fine ? 0.0 : 0.6;
}

/// The place among others: its outlines stand out and no surfaces contradict them, or its surfaces
/// do. Right places whose surfaces were compared have a support of 0.6 or more.
double place_factor(const Evidence& e, const VerdictOptions& o) {
  const double by_outlines = ramp(peak_ratio(e), o.max_peak_ratio, o.doubtful_peak_ratio);
  if (!e.surfaces_compared || by_outlines >= 1.0) return by_outlines;
  const double unopposed =
      by_outlines * ramp(e.facade_support, 0.5 * o.min_facade_support, 0.8 * o.min_facade_support);
  if (e.facade_support <= 0.0) return unopposed;
  const double ratio = e.rival_support / e.facade_support;
  return std::max(unopposed,
                  support_factor(e, o) * ramp(ratio, o.max_peak_ratio, o.doubtful_peak_ratio));
}

/// Few patches are no majority; that not one of them met anything is a doubt.
double vote_factor(const Evidence& e, const VerdictOptions& o) {
  constexpr std::size_t kMinVoters = 6;
  constexpr double kNoVoter = 0.8;
  if (o.min_patch_share == 0.0) return 1.0;
  if (e.has_fine && e.patches_tried == 0) return kNoVoter;
  if (e.patches_tried < kMinVoters) return 1.0;
  return ramp(e.patch_share, o.min_patch_share, 2.0 * o.min_patch_share);
}

/// The place among others, its surfaces, and the votes of patches.
std::vector<Factor> weigh(const Evidence& e, const VerdictOptions& o) {
  constexpr double kDeg = 57.29577951308232;
  const double ratio = peak_ratio(e);
  std::vector<Factor> factors{
      {ramp(e.best.facade_weight_on_edges, o.min_facade_weight, 2.4 * o.min_facade_weight),
       fmt::format("only {:.0f} facade columns meet a roof rim (limit {:.0f}): too little overlap, "
                   "or no buildings",
                   e.best.facade_weight_on_edges,
                   o.min_facade_weight)},
      {place_factor(e, o),
       fmt::format("ambiguous: a place {:.1f} m away (bearing {:.0f} deg from x), turned by {:.0f} "
                   "deg, scores {:.2f} of the best (limit {:.2f}); give a better initial pose with "
                   "its covariance or a larger LiDAR cloud",
                   e.second_offset.norm(),
                   kDeg * std::atan2(e.second_offset.y(), e.second_offset.x()),
                   std::abs(std::remainder(kDeg * e.second_turn_rad, 360.0)),
                   ratio,
                   o.max_peak_ratio)},
      {ramp(e.ridge.ratio, o.max_ridge_ratio, o.max_ridge_ratio - 0.1),
       fmt::format("the position is free along {:.0f} deg from x: 3 m away the outlines still "
                   "score {:.2f} (limit {:.2f})",
                   kDeg * e.ridge.bearing_rad,
                   e.ridge.ratio,
                   o.max_ridge_ratio)},
      {vote_factor(e, o),
       fmt::format("registered alone, only {:.2f} of {} patches stay at the pose (limit {:.2f})",
                   e.patch_share,
                   e.patches_tried,
                   o.min_patch_share)},
      {surface_factor(e, o), "the surfaces lead away from the place that the outlines found"},
      {e.ground_inliers == 0 ? 0.0 : 1.0, "no LiDAR ground lies on vision ground"},
  };
  std::ranges::move(weigh_surfaces(e.best, o), std::back_inserter(factors));
  return factors;
}

/// The complaint of the weakest factor when the product is too small; empty when it is not.
std::string reason_to_refuse(const std::vector<Factor>& factors,
                             double confidence,
                             double sigma_m,
                             const VerdictOptions& options) {
  if (sigma_m > options.max_sigma_m) {
    return fmt::format("the surfaces leave the position uncertain by {:.2f} m (limit {:.2f} m)",
                       sigma_m,
                       options.max_sigma_m);
  }
  if (confidence >= options.min_confidence) return {};
  return weakest(factors, confidence, options.min_confidence);
}

}  // namespace

SurfaceVerdict judge_surfaces(const PoseEvidence& evidence, const VerdictOptions& options) {
  const std::vector<Factor> factors = weigh_surfaces(evidence, options);
  SurfaceVerdict verdict{.confidence = product(factors)};
  if (verdict.confidence < options.min_confidence) {
    verdict.reason = weakest(factors, verdict.confidence, options.min_confidence);
  }
  return verdict;
}

void pronounce(const Evidence& e, const VerdictOptions& o, RegistrationResult& result) {
  const double sigma_m = std::sqrt(result.covariance.topLeftCorner<3, 3>().trace());
  const double ratio = peak_ratio(e);
  result.scores = {
      {"outline_score", e.best_score},
      {"second_score", e.second_score},
      {"peak_ratio", ratio},
      {"ridge_ratio", e.ridge.ratio},
      {"facade_weight_on_edges", e.best.facade_weight_on_edges},
      {"facade_share_on_edges", e.best.facade_share},
      {"facade_share_inside", e.best.facade_inside_share},
      {"facade_share_on_ground", e.best.facade_on_ground},
      {"facade_share_linear", e.linear_share},
      {"ground_cells", static_cast<double>(e.best.num_ground)},
      {"ground_inliers", static_cast<double>(e.ground_inliers)},
      {"ground_share_within_0.2_m", e.best.ground_share},
      {"free_space_violations", e.best.free_violations},
      {"prior_decided", e.used_prior ? 1.0 : 0.0},
      {"fine_agrees", e.fine_agrees ? 1.0 : 0.0},
      {"surfaces_compared", e.surfaces_compared ? 1.0 : 0.0},
      {"facade_support", e.facade_support},
      {"rival_facade_support", e.rival_support},
      {"fine_vertical_pairs", static_cast<double>(e.fine.num_vertical)},
      {"fine_horizontal_pairs", static_cast<double>(e.fine.num_horizontal)},
      {"fine_vertical_rms_m", e.fine.vertical_rms_m},
      {"fine_horizontal_rms_m", e.fine.horizontal_rms_m},
      {"fine_gate_m", e.fine.gate_m},
      {"held_out_median_m", e.fine.held_out_median_m},
      {"held_out_share", e.fine.held_out_share},
      {"position_sigma_m", sigma_m},
      {"patches_tried", static_cast<double>(e.patches_tried)},
      {"patch_cluster_share", e.patch_share},
      {"patch_spread_m", e.patch_spread_m},
      {"drift_size_m", result.drift.size_m},
      {"drift_held_out_before_m", result.drift.held_out_before_m},
      {"drift_held_out_after_m", result.drift.held_out_after_m},
      {"drift_supported", result.drift.supported ? 1.0 : 0.0},
  };
  const std::vector<Factor> factors = weigh(e, o);
  const double confidence = product(factors);
  result.reason = reason_to_refuse(factors, confidence, sigma_m, o);
  if (!result.reason.empty()) {
    result.status = RegistrationStatus::kRefused;
    // Evidence for the place says nothing of a pose that the surfaces leave loose.
    result.confidence = sigma_m > o.max_sigma_m ? 0.0 : confidence;
    return;
  }
  result.status = RegistrationStatus::kOk;
  result.confidence = confidence;
  if (!e.has_fine) {
    result.reason = "too few surfaces in common to refine the pose; it is that of the outlines";
  } else if (!e.fine.horizontal_updated) {
    result.reason = "few facades in the vision cloud: position and heading are from the outlines";
  }
}

}  // namespace hybridfusion
