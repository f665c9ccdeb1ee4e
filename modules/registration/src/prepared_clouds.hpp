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
  double lidar_diagonal_m = 0.0;            ///< Of the LiDAR cloud's box in plan.
};

/// The LiDAR half: everything but `vision`, its ground and its maps.
/// @returns kInsufficient when the cloud is unusable, kDegenerate when it has no ground surface.
[[nodiscard]] Expected<PreparedClouds> prepare_lidar(const PointCloud& lidar,
                                                     const RegistrationInput& input,
                                                     const RegistrationOptions& options,
                                                     const RunContext& ctx);

/// The vision half, from some points of the vision cloud.
/// @returns kDegenerate when they are too few or have no ground surface; kInsufficient when their
/// rasters would not fit in memory.
[[nodiscard]] Expected<void> prepare_vision(std::vector<Eigen::Vector3f> points,
                                            const RegistrationOptions& options,
                                            const RunContext& ctx,
                                            PreparedClouds& clouds);

/// Vision points that the search window can bring L to; all, when no coarse pose limits it. Memory
/// and time then follow the size of L, not that of the flight.
/// @param clouds  The LiDAR half.
[[nodiscard]] std::vector<Eigen::Vector3f> reachable_vision(const PointCloud& vision,
                                                            const PreparedClouds& clouds,
                                                            const RegistrationInput& input,
                                                            double max_offset_m);

/// The LiDAR half, once the vision cloud too is known to be usable: consistent channels and at
/// least 1000 finite points.
[[nodiscard]] Expected<PreparedClouds> prepare_lidar_of_pair(const PointCloud& vision,
                                                             const PointCloud& lidar,
                                                             const RegistrationInput& input,
                                                             const RegistrationOptions& options,
                                                             const RunContext& ctx);

/// Both halves, of the vision points within reach. Errors as of these.
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
