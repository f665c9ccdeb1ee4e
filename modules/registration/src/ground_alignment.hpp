#pragma once

#include "outline_maps.hpp"
#include "outline_search.hpp"

#include <hybridfusion/core/rigid3.hpp>

#include <vector>

namespace hybridfusion {

/// A planar pose raised to 3D: heading about z after `tilt`, the pattern's centre at `position`.
/// @param height_m  z of the LiDAR frame's origin in vision, before ground alignment.
[[nodiscard]] Rigid3 lift(const PlanarPose& pose,
                          const PlanarPattern& pattern,
                          const Eigen::Matrix3d& tilt,
                          double height_m);

/// The planar pose of `pattern` under `pose`: the inverse of lift, with the overhang kept.
[[nodiscard]] PlanarPose planar_of(const Rigid3& pose,
                                   const PlanarPattern& pattern,
                                   double overhang_m);

/// A rotation R = Rz(yaw) * tilt.
struct HeadingTilt {
  double yaw_rad = 0.0;
  Eigen::Matrix3d tilt = Eigen::Matrix3d::Identity();
};
[[nodiscard]] HeadingTilt split_heading(const Eigen::Quaterniond& rotation);

struct GroundAlignment {
  Rigid3 vision_from_lidar = {};
  std::size_t num_cells = 0;    ///< LiDAR ground cells over vision ground cells.
  std::size_t num_inliers = 0;  ///< Of these within the last gate.
  double rms_m = 0.0;           ///< Of the inliers.
};

/// Height, roll and pitch of a pose from open LiDAR ground over vision ground: dz = a + b x + c y,
/// Tukey from 1.0 m shrinking to 0.1 m. Position and heading stay.
/// @returns kInsufficient with fewer than `min_cells` common cells.
[[nodiscard]] Expected<GroundAlignment> align_ground(const VisionMaps& vision,
                                                     const LidarMaps& lidar,
                                                     const Rigid3& vision_from_lidar,
                                                     std::size_t min_cells);

/// How well a pose explains both clouds, as shares in [0, 1].
struct PoseEvidence {
  double facade_weight_inside = 0.0;  ///< Facade weight over known vision cells.
  double facade_weight_on_edges = 0.0;
  double facade_share = 0.0;         ///< On rims, of the weight inside.
  double facade_on_ground = 0.0;     ///< Over open vision ground, of the weight inside.
  double facade_inside_share = 0.0;  ///< Of all facade weight, over known vision cells.
  double ground_share = 0.0;         ///< LiDAR ground within 0.2 m of vision ground.
  double free_violations = 0.0;      ///< LiDAR ground inside vision buildings.
  std::size_t num_ground = 0;        ///< LiDAR ground cells over known vision cells.
};
[[nodiscard]] PoseEvidence judge_pose(const VisionMaps& vision,
                                      const LidarMaps& lidar,
                                      const Rigid3& vision_from_lidar,
                                      double overhang_m);

}  // namespace hybridfusion
