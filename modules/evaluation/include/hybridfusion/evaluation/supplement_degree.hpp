#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>

#include <span>

#include <Eigen/Core>

namespace hybridfusion {

/// Total volume of the occupied cells of a regular grid of edge `leaf_m`, anchored at the origin
/// [m^3]. Equals the octree leaf volume of HybridFusion IV-A when the octree is anchored the same
/// way, so that volumes are repeatable. @pre leaf_m > 0
[[nodiscard]] double occupied_volume_m3(std::span<const Eigen::Vector3f> points, double leaf_m);

/// S_pt = (V_O - V_G) / V_G, where O is G plus the registered LiDAR cloud (HybridFusion IV-A).
/// Dimensionless. @pre vision_volume_m3 > 0
[[nodiscard]] double supplement_degree(double fused_volume_m3, double vision_volume_m3);

/// One row of HybridFusion Table I at one leaf size.
struct VolumeComparison {
  double leaf_m = 0.0;
  double vision_volume_m3 = 0.0;                         ///< V_G inside the extent.
  double fused_volume_m3 = 0.0;                          ///< V_O inside the extent.
  double supplement_degree = 0.0;                        ///< S_pt, 1.
  Eigen::Vector2d extent_min = Eigen::Vector2d::Zero();  ///< Compared rectangle, frame of G [m].
  Eigen::Vector2d extent_max = Eigen::Vector2d::Zero();
};

/// Volumes of G and of O = G and L, both cut to the bounding rectangle of L grown by one leaf:
/// what the photos saw beyond the street drive must not dilute the ratio. Both clouds are in the
/// frame of G.
/// @returns kInsufficient when L is empty or no point of G lies in the rectangle.
[[nodiscard]] Expected<VolumeComparison> compare_volumes(const PointCloud& vision,
                                                         const PointCloud& lidar_in_vision,
                                                         double leaf_m);

}  // namespace hybridfusion
