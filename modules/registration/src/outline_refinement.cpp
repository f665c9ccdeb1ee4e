#include "outline_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace hybridfusion {

double score_of(const VisionMaps& vision,
                const PlanarPattern& pattern,
                const PlanarPose& pose,
                double free_penalty) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  double score = 0.0;
  for (const PlanarPattern::Facade& f : pattern.facades) {
    const Eigen::Vector2d p = pose.position + turn * (f.point + pose.overhang_m * f.outward);
    score += f.weight * static_cast<double>(vision.edge.sample(p.x(), p.y()));
  }
  for (const Eigen::Vector2d& free_point : pattern.free_points) {
    const Eigen::Vector2d p = pose.position + turn * free_point;
    score -= free_penalty * kFreeWeight * static_cast<double>(vision.interior.sample(p.x(), p.y()));
  }
  return score;
}

PlanarPose refine_pose(const VisionMaps& vision,
                       const PlanarPattern& pattern,
                       const PlanarPose& start,
                       double step_m,
                       const OutlineOptions& options) {
  PlanarPose best = start;
  best.score = score_of(vision, pattern, best, options.free_penalty);
  // A heading step moves the outer third of the pattern as far as a position step.
  const double radius_m = std::max(1.0, 0.6 * pattern.reach_m);
  for (double step = step_m; step > 0.05 * vision.edge.grid.cell_m; step *= 0.5) {
    for (int round = 0; round < 20; ++round) {
      const PlanarPose centre = best;
      for (const Eigen::Vector4d& move : {Eigen::Vector4d(1, 0, 0, 0),
                                          Eigen::Vector4d(-1, 0, 0, 0),
                                          Eigen::Vector4d(0, 1, 0, 0),
                                          Eigen::Vector4d(0, -1, 0, 0),
                                          Eigen::Vector4d(0, 0, 1, 0),
                                          Eigen::Vector4d(0, 0, -1, 0),
                                          Eigen::Vector4d(0, 0, 0, 1),
                                          Eigen::Vector4d(0, 0, 0, -1)}) {
        PlanarPose trial = best;
        trial.position += step * move.head<2>();
        trial.yaw_rad =
            std::remainder(trial.yaw_rad + step / radius_m * move[2], 2.0 * std::numbers::pi);
        trial.overhang_m = std::clamp(
            trial.overhang_m + step * move[3], options.min_overhang_m, options.max_overhang_m);
        trial.score = score_of(vision, pattern, trial, options.free_penalty);
        if (trial.score > best.score) best = trial;
      }
      if (best.score <= centre.score) break;
    }
  }
  return best;
}

}  // namespace hybridfusion
