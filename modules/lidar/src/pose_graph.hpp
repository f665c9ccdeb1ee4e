#pragma once

#include "pose_equations.hpp"

#include <optional>

namespace hybridfusion {

/// A position that something else than the graph knows.
struct PositionPrior {
  std::uint32_t pose = 0;
  Eigen::Vector3d lever_in_body = Eigen::Vector3d::Zero();  ///< Of what was measured [m].
  Eigen::Vector3d point_in_map = Eigen::Vector3d::Zero();   ///< [m]
  double sigma_m = 1.0;
};

/// Poses joined by odometry and loops.
struct PoseGraph {
  std::vector<RelativePose> odometry = {};
  std::vector<VelocityChange> velocity_changes = {};
  std::vector<RelativePose> loops = {};
  std::vector<PositionPrior> positions = {};
  /// Up in each body, as gravity shows it; the map is level. Empty: no such knowledge.
  std::vector<Eigen::Vector3d> up_in_body = {};
  double up_sigma_rad = 3e-3;
};

struct PoseGraphReport {
  int iterations = 0;
  /// Root of the weighted squared residual of each loop at the end, in standard deviations.
  std::vector<double> loop_sigmas = {};
};

/// Robust Gauss-Newton over all poses; the first stays. Loops carry Cauchy weights whose scale
/// shrinks to `robust_sigmas` (graduated non-convexity, after Yang et al. 2020), so that loops that
/// contradict the others and the odometry lose their say.
/// @returns kDegenerate.
[[nodiscard]] Expected<PoseGraphReport> optimize_pose_graph(const PoseGraph& graph,
                                                            double robust_sigmas,
                                                            std::vector<Rigid3>& map_from_body);

}  // namespace hybridfusion
