#include "pose_graph.hpp"

#include "manifold.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr int kMaxIterations = 40;
constexpr double kShrink = 0.6;
constexpr double kConverged_m = 1e-4;
// Positions farther off than this many deviations hardly count.
constexpr double kPositionScale = 2.0;

double squared_sigmas(const RelativePose& edge, const std::vector<Rigid3>& poses) {
  const PoseVector r = residual_of(edge, poses[edge.first], poses[edge.second]);
  return r.dot(edge.information * r);
}

void add_up(const Eigen::Vector3d& up_in_body,
            double sigma_rad,
            std::uint32_t index,
            const Rigid3& pose,
            PoseEquations& equations) {
  // r = R u - e_z with d r / d theta = -R [u]x; the turn about z is free.
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  const Eigen::Matrix3d j = -rotation * skew(up_in_body);
  const Eigen::Vector3d residual = rotation * up_in_body - Eigen::Vector3d::UnitZ();
  const double weight = 1.0 / (sigma_rad * sigma_rad);
  equations.block(index, index).bottomRightCorner<3, 3>() += weight * j.transpose() * j;
  equations.right(index).tail<3>() -= weight * j.transpose() * residual;
}

void add_position(const PositionPrior& prior, const Rigid3& pose, PoseEquations& equations) {
  const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
  Eigen::Matrix<double, 3, 6> j;
  j << Eigen::Matrix3d::Identity(), -rotation * skew(prior.lever_in_body);
  const Eigen::Vector3d residual = pose * prior.lever_in_body - prior.point_in_map;
  const double scaled2 = residual.squaredNorm() / (prior.sigma_m * prior.sigma_m);
  const double weight =
      1.0 / (prior.sigma_m * prior.sigma_m * (1.0 + scaled2 / (kPositionScale * kPositionScale)));
  equations.block(prior.pose, prior.pose) += weight * j.transpose() * j;
  equations.right(prior.pose) -= weight * j.transpose() * residual;
}

}  // namespace

Expected<PoseGraphReport> optimize_pose_graph(const PoseGraph& graph,
                                              double robust_sigmas,
                                              std::vector<Rigid3>& map_from_body) {
  PoseGraphReport report;
  double scale2 = robust_sigmas * robust_sigmas;
  for (const RelativePose& loop : graph.loops) {
    scale2 = std::max(scale2, squared_sigmas(loop, map_from_body));
  }
  const double final_scale2 = robust_sigmas * robust_sigmas;
  for (int i = 0; i < kMaxIterations && map_from_body.size() > 1; ++i) {
    PoseEquations equations(map_from_body.size());
    for (const RelativePose& edge : graph.odometry) add_edge(edge, 1.0, map_from_body, equations);
    for (const VelocityChange& change : graph.velocity_changes) {
      add_velocity_change(change, map_from_body, equations);
    }
    for (const RelativePose& loop : graph.loops) {
      const double weight = 1.0 / (1.0 + squared_sigmas(loop, map_from_body) / scale2);
      add_edge(loop, weight, map_from_body, equations);
    }
    for (const PositionPrior& prior : graph.positions) {
      add_position(prior, map_from_body[prior.pose], equations);
    }
    for (std::uint32_t p = 0; p < graph.up_in_body.size(); ++p) {
      add_up(graph.up_in_body[p], graph.up_sigma_rad, p, map_from_body[p], equations);
    }
    HF_TRY(const Eigen::VectorXd step, equations.solve());
    const double moved_m = apply_step(step, map_from_body);
    report.iterations = i + 1;
    if (scale2 <= final_scale2 && moved_m < kConverged_m) break;
    scale2 = std::max(final_scale2, kShrink * scale2);
  }
  for (const RelativePose& loop : graph.loops) {
    report.loop_sigmas.push_back(std::sqrt(squared_sigmas(loop, map_from_body)));
  }
  return report;
}

}  // namespace hybridfusion
