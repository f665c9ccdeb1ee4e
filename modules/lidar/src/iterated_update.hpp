#pragma once

#include "imu_propagation.hpp"
#include "scan_matching.hpp"

#include <functional>

namespace hybridfusion {

/// Directions that the matched planes do not determine, and the information without them.
struct ObservedInformation {
  MatchMatrix information = MatchMatrix::Zero();
  MatchVector gradient = MatchVector::Zero();
  double min_position_information = 0.0;  ///< Smallest eigenvalue, rotation marginalised [1/m^2].
  int num_held = 0;                       ///< Directions taken out.
};

/// Takes directions out of `matches` whose share of the total weight is below `min_ratio`, so that
/// an update leaves them at the prediction.
[[nodiscard]] ObservedInformation hold_unobserved(const MatchInformation& matches,
                                                  double min_ratio);

struct UpdateReport {
  int num_matched = 0;
  double mean_residual_m = 0.0;
  double min_information = 0.0;
  /// Squared correction by the points over its predicted variance, mean of three axes: about 1 when
  /// the prediction is as good as it says.
  double turn_innovation = 0.0;
  double shift_innovation = 0.0;
  std::uint32_t flags = 0;  ///< ScanFlag bits: unmatched, degenerate, diverged.
};

/// Iterated update of `estimate` (the prediction) by the points of `matcher` (FAST-LIO2, Algorithm
/// 1), in information form over the pose only. Left as predicted when flagged unmatched or
/// diverged.
/// @param repeat_deskew  Called with the state after the first pass; updates the points. (After
/// every pass when the extrinsic is estimated.)
[[nodiscard]] UpdateReport iterated_update(
    const LidarFilterOptions& options,
    const std::function<void(const NavState&, ScanMatcher&)>& repeat_deskew,
    ScanMatcher& matcher,
    StateEstimate& estimate);

}  // namespace hybridfusion
