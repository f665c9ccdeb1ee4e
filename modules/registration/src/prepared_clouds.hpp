#pragma once

#include "ground_alignment.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <vector>

namespace hybridfusion {

/// Both clouds, thinned, with their grounds and outline maps. The LiDAR cloud is turned by the roll
/// and pitch of the coarse pose, so that both are level: "leveled" below is that frame.
struct PreparedClouds {
  std::vector<Eigen::Vector3f> vision = {};
  std::vector<Eigen::Vector3f> lidar = {};                   ///< In the leveled frame.
  Eigen::Vector3d lidar_centroid = Eigen::Vector3d::Zero();  ///< In the leveled frame.
  GroundModel vision_ground = {};
  GroundModel lidar_ground = {};
  VisionMaps search_maps = {};  ///< At search_cell_m.
  VisionMaps maps = {};         ///< At refine_cell_m.
  LidarMaps lidar_maps = {};
  Eigen::Quaterniond leveled_from_lidar = Eigen::Quaterniond::Identity();
  Rigid3 vision_from_leveled_initial = {};  ///< Heading and translation only.
};

/// @returns kInsufficient when a cloud is unusable, kDegenerate when one has no ground surface.
[[nodiscard]] Expected<PreparedClouds> prepare_clouds(const PointCloud& vision,
                                                      const PointCloud& lidar,
                                                      const RegistrationInput& input,
                                                      const RegistrationOptions& options,
                                                      const RunContext& ctx);

/// The coarse pose lifted so that the grounds meet at the median of their common cells: vertical
/// GNSS errors of several metres otherwise decide what local methods find.
[[nodiscard]] Rigid3 height_aligned_initial(const PreparedClouds& clouds);

/// Pose and covariance of the leveled frame brought back to the LiDAR frame.
[[nodiscard]] Rigid3 from_leveled(const Rigid3& vision_from_leveled, const PreparedClouds& clouds);
[[nodiscard]] PoseCovariance from_leveled(const PoseCovariance& covariance,
                                          const PreparedClouds& clouds);

}  // namespace hybridfusion
