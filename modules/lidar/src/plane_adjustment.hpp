#pragma once

#include "scan_store.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Points of one segment of the drive within one map cell: their count and moments, enough for
/// exact point-to-plane sums at any pose of the segment.
struct PlaneCluster {
  std::uint64_t cell = 0;
  std::uint32_t segment = 0;
  float count = 0.0F;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();        ///< In the segment's frame [m].
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();  ///< About the mean [m^2].
};

/// Pose change between neighbouring segments that odometry measured.
struct SegmentLink {
  Rigid3 first_from_second = {};
  double sigma_m = 0.03;
  double sigma_rad = 3e-3;
};

struct PlaneAdjustmentReport {
  std::size_t num_planes = 0;
  double rms_before_m = 0.0;  ///< Weighted point-to-plane distance.
  double max_shift_m = 0.0;   ///< Largest move of a segment in the pass.
};

/// One Gauss-Newton pass over all segment poses and all planes at once; the planes are eliminated
/// (as in bundle adjustment), so that a wall seen twice pulls both visits together. The first
/// segment stays.
/// @param clusters  Sorted by cell, then segment.
/// @param links     links[i] joins segments i and i + 1.
/// @returns kDegenerate when the system cannot be solved.
[[nodiscard]] Expected<PlaneAdjustmentReport> adjust_planes(std::span<const PlaneCluster> clusters,
                                                            std::span<const SegmentLink> links,
                                                            double max_plane_sigma_m,
                                                            std::vector<Rigid3>& map_from_segment);

}  // namespace hybridfusion
