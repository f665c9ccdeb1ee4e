#pragma once

#include "drive_path.hpp"

#include <cstddef>
#include <vector>

namespace hybridfusion {

/// Where a drive from rest begins its way, and where any drive ends it.
inline constexpr double kCreep_mps = 0.35;

/// Point of the way `s` metres along it, held at its ends.
[[nodiscard]] Eigen::Vector2d point_on(const DrivePlan& plan, double s);

/// Highest speed at each point of the path when nothing exceeds `cruise`, the curve limits and the
/// pedals, and the first point is passed at `start_mps` at most.
[[nodiscard]] std::vector<double> speed_profile(const DrivePlan& plan,
                                                double cruise,
                                                double start_mps);

/// Time for the whole path [s].
[[nodiscard]] double travel_time(const std::vector<double>& speed);

/// Distance along the path at `steps` times from `first_s` on, kTimeStep_s apart; standing before
/// `depart_s` and behind the end.
[[nodiscard]] std::vector<double> distance_at_times(const std::vector<double>& speed,
                                                    double depart_s,
                                                    double first_s,
                                                    std::size_t steps);

}  // namespace hybridfusion
