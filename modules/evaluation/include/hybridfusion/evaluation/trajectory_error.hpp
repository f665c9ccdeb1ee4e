#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <cstddef>

namespace hybridfusion {

/// Error of the motion between two moments, over all such pairs of a trajectory.
struct RelativeErrors {
  std::size_t num_pairs = 0;
  double translation_rmse_m = 0.0;
  double rotation_rmse_deg = 0.0;
};

/// Measures of Sturm et al. (IROS 2012). The truth is interpolated at the estimate's times.
struct TrajectoryErrors {
  std::size_t num_poses = 0;  ///< Estimated poses inside the true time span.
  double path_m = 0.0;        ///< Length of the true path over these poses.
  double ate_rmse_m = 0.0;    ///< Absolute trajectory error after the best rigid alignment.
  double ate_max_m = 0.0;
  double rotation_rmse_deg = 0.0;  ///< After the same alignment.
  double tilt_deg = 0.0;           ///< Angle between the map's up and the true up.
  double scale_error = 0.0;        ///< Estimated size over true size - 1.
  RelativeErrors over_1_s = {};
  RelativeErrors over_50_m = {};
  Rigid3 truth_from_map = {};
};

/// @param truth, estimate  truth_from_body and map_from_body of the same body on the same clock.
/// A straight path, whose positions leave one rotation open, is aligned with its orientations too.
/// @returns kInsufficient below 3 common poses.
[[nodiscard]] Expected<TrajectoryErrors> trajectory_errors(const Trajectory& truth,
                                                           const Trajectory& estimate);

}  // namespace hybridfusion
