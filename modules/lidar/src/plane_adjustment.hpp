#pragma once

#include "pose_equations.hpp"

#include <hybridfusion/core/error.hpp>

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

struct PlaneAdjustmentReport {
  std::size_t num_planes = 0;
  double rms_before_m = 0.0;  ///< Weighted point-to-plane distance.
  double max_shift_m = 0.0;   ///< Largest move of a segment in the pass.
};

/// One Gauss-Newton pass over all segment poses and all planes at once; the planes are eliminated
/// (as in bundle adjustment), so that a wall seen twice pulls both visits together. The first
/// segment stays. Clusters come in batches, so that they need not be in memory together.
class PlaneAdjustment {
 public:
  /// @param held  Per segment the projector (map axes) onto the directions that its planes hold;
  /// along others the links alone decide. Empty: all directions of all segments.
  PlaneAdjustment(double max_plane_sigma_m,
                  std::vector<Rigid3> map_from_segment,
                  std::vector<Eigen::Matrix3d> held = {});

  /// @param clusters  All of their cells, sorted by cell, then segment.
  void add(std::span<const PlaneCluster> clusters);
  /// Moves the segments. @param links  What odometry measured between segments; they join them all.
  /// @returns kDegenerate when the system cannot be solved.
  [[nodiscard]] Expected<PlaneAdjustmentReport> solve(
      std::span<const RelativePose> links, std::span<const VelocityChange> velocity_changes = {});
  [[nodiscard]] const std::vector<Rigid3>& map_from_segment() const { return map_from_segment_; }

 private:
  void add_cell(std::span<const PlaneCluster> members);

  double max_plane_sigma_m_;
  std::vector<Rigid3> map_from_segment_;
  std::vector<Eigen::Matrix3d> held_;
  PoseEquations equations_;
  PlaneAdjustmentReport report_ = {};
  double sum_squares_ = 0.0;
  double sum_weights_ = 0.0;
};

}  // namespace hybridfusion
