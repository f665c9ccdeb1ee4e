#include "ground_alignment.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

struct HeightPair {
  Eigen::Vector3d point;  ///< LiDAR ground in vision [m].
  double gap_m;           ///< Vision ground above it.
};

std::vector<HeightPair> pair_heights(const VisionMaps& vision,
                                     const LidarMaps& lidar,
                                     const Rigid3& vision_from_lidar) {
  std::vector<HeightPair> pairs;
  for (const Eigen::Vector3d& cell : lidar.free_cells) {
    const Eigen::Vector3d p = vision_from_lidar * cell;
    const float z = vision.ground_z.nearest(p.x(), p.y());
    if (!std::isnan(z)) pairs.push_back({p, static_cast<double>(z) - p.z()});
  }
  return pairs;
}

double median_gap(const std::vector<HeightPair>& pairs) {
  std::vector<double> gaps;
  gaps.reserve(pairs.size());
  for (const HeightPair& pair : pairs) gaps.push_back(pair.gap_m);
  std::ranges::nth_element(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2));
  return gaps[gaps.size() / 2];
}

double tukey(double residual, double width) {
  const double ratio = residual / width;
  return std::abs(ratio) < 1.0 ? (1.0 - ratio * ratio) * (1.0 - ratio * ratio) : 0.0;
}

}  // namespace

Rigid3 lift(const PlanarPose& pose,
            const PlanarPattern& pattern,
            const Eigen::Matrix3d& tilt,
            double height_m) {
  const Eigen::AngleAxisd heading(pose.yaw_rad, Eigen::Vector3d::UnitZ());
  Rigid3 vision_from_lidar;
  vision_from_lidar.rotation = Eigen::Quaterniond(heading.toRotationMatrix() * tilt).normalized();
  const Eigen::Vector3d centre(pattern.centre.x(), pattern.centre.y(), 0.0);
  vision_from_lidar.translation =
      Eigen::Vector3d(pose.position.x(), pose.position.y(), height_m) - heading * centre;
  return vision_from_lidar;
}

PlanarPose planar_of(const Rigid3& pose, const PlanarPattern& pattern, double overhang_m) {
  PlanarPose planar{.yaw_rad = split_heading(pose.rotation).yaw_rad, .overhang_m = overhang_m};
  const Eigen::Vector3d centre(pattern.centre.x(), pattern.centre.y(), 0.0);
  const Eigen::AngleAxisd heading(planar.yaw_rad, Eigen::Vector3d::UnitZ());
  planar.position = (pose.translation + heading * centre).head<2>();
  return planar;
}

HeadingTilt split_heading(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d full = rotation.toRotationMatrix();
  const double yaw_rad = std::atan2(full(1, 0) - full(0, 1), full(0, 0) + full(1, 1));
  return {.yaw_rad = yaw_rad, .tilt = Eigen::AngleAxisd(-yaw_rad, Eigen::Vector3d::UnitZ()) * full};
}

Expected<GroundAlignment> align_ground(const VisionMaps& vision,
                                       const LidarMaps& lidar,
                                       const Rigid3& vision_from_lidar,
                                       std::size_t min_cells) {
  GroundAlignment result{.vision_from_lidar = vision_from_lidar};
  constexpr int kRounds = 10;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<HeightPair> pairs = pair_heights(vision, lidar, result.vision_from_lidar);
    if (pairs.size() < min_cells) {
      return fail(ErrorCode::kInsufficient,
                  fmt::format("{} ground cells are seen by both clouds, at least {} are needed",
                              pairs.size(),
                              min_cells));
    }
    // The tilt is free from the second round on: first the median height, whatever the slope.
    const double width = std::pow(0.1, round / (kRounds - 1.0));
    const double middle = round < 2 ? median_gap(pairs) : 0.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const HeightPair& pair : pairs) centre += pair.point / static_cast<double>(pairs.size());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    result.num_cells = pairs.size();
    result.num_inliers = 0;
    double squares = 0.0;
    for (const HeightPair& pair : pairs) {
      const double weight = tukey(pair.gap_m - middle, round < 2 ? 3.0 : width);
      if (weight <= 0.0) continue;
      const Eigen::Vector3d b(1.0, pair.point.x() - centre.x(), pair.point.y() - centre.y());
      normal += weight * b * b.transpose();
      right += weight * pair.gap_m * b;
      ++result.num_inliers;
      squares += pair.gap_m * pair.gap_m;
    }
    normal.diagonal() += Eigen::Vector3d(1e-9, 1.0, 1.0);
    Eigen::Vector3d plane = normal.ldlt().solve(right);
    if (round == 0) plane = Eigen::Vector3d(middle, 0.0, 0.0);
    result.rms_m =
        std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, result.num_inliers)));
    // dz = a + b x + c y is a lift by a and a small rotation (c, -b, 0) about the centre.
    const Eigen::Vector3d turn(plane[2], -plane[1], 0.0);
    Rigid3 step;
    if (turn.norm() > 0.0) {
      step.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
    }
    step.translation = centre + Eigen::Vector3d(0.0, 0.0, plane[0]) - step.rotation * centre;
    result.vision_from_lidar = step * result.vision_from_lidar;
  }
  return result;
}

PoseEvidence judge_pose(const VisionMaps& vision,
                        const LidarMaps& lidar,
                        const Rigid3& vision_from_lidar,
                        double overhang_m) {
  PoseEvidence evidence;
  const Eigen::Matrix3d turn = vision_from_lidar.rotation.toRotationMatrix();
  const int reach = static_cast<int>(std::lround(1.5 / vision.height.grid.cell_m));
  for (const FacadeCell& facade : lidar.facades) {
    const Eigen::Vector3d outward(facade.outward.x(), facade.outward.y(), 0.0);
    const Eigen::Vector3d p = vision_from_lidar * facade.mean + overhang_m * (turn * outward);
    if (std::isnan(vision.height.nearest(p.x(), p.y()))) continue;
    evidence.facade_weight_inside += facade.weight;
    if (vision.edge.sample(p.x(), p.y()) > 0.4F) evidence.facade_weight_on_edges += facade.weight;
    float highest = -1e9F;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const double cell = vision.height.grid.cell_m;
        const float h = vision.height.nearest(p.x() + dx * cell, p.y() + dy * cell);
        if (h > highest) highest = h;
      }
    }
    if (highest < 1.0F) evidence.facade_on_ground += facade.weight;
  }
  const double inside = std::max(1e-9, evidence.facade_weight_inside);
  evidence.facade_share = evidence.facade_weight_on_edges / inside;
  evidence.facade_on_ground /= inside;
  evidence.facade_inside_share = inside / std::max(1e-9, lidar.facade_weight);

  double agree = 0.0;
  double disagree = 0.0;
  double violations = 0.0;
  for (const Eigen::Vector3d& cell : lidar.free_cells) {
    const Eigen::Vector3d p = vision_from_lidar * cell;
    if (std::isnan(vision.height.nearest(p.x(), p.y()))) continue;
    ++evidence.num_ground;
    const float z = vision.ground_z.nearest(p.x(), p.y());
    if (vision.interior.sample(p.x(), p.y()) > 0.5F) {
      violations += 1.0;
    } else if (!std::isnan(z)) {
      (std::abs(static_cast<double>(z) - p.z()) < 0.2 ? agree : disagree) += 1.0;
    }
  }
  evidence.ground_share = agree / std::max(1.0, agree + disagree + violations);
  evidence.free_violations = violations / std::max<double>(1.0, agree + disagree + violations);
  return evidence;
}

}  // namespace hybridfusion
