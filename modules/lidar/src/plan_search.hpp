#pragma once

#include "submap.hpp"

#include <vector>

namespace hybridfusion {

/// Where a submap may lie in another: point_target = Rz(yaw) point_source + shift.
struct PlanPose {
  double yaw_rad = 0.0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
};

struct PlanMatch {
  PlanPose pose = {};
  double score = 0.0;  ///< 0..1: mean agreement of the source's walls.
};

struct PlanWindow {
  PlanPose centre = {};
  double radius_m = 0.0;
  double yaw_rad = 0.0;  ///< Each way.
};

/// The best places of the source's walls among the target's, best first, at least
/// `kPlanSeparation_m` apart: exact branch and bound over shifts of half a metre and turns of a
/// degree (after Hess et al. 2016, "Real-time loop closure in 2D LIDAR SLAM"). At most
/// `max_matches` with a score of `min_score` or more.
[[nodiscard]] std::vector<PlanMatch> search_plan(const Submap& target,
                                                 const Submap& source,
                                                 const PlanWindow& window,
                                                 double min_score,
                                                 std::size_t max_matches);

inline constexpr double kPlanSeparation_m = 2.5;

}  // namespace hybridfusion
