#pragma once

#include <hybridfusion/core/rigid3.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hybridfusion {

/// How far a LiDAR patch came, in the published chain or in the vote on a pose.
enum class PatchOutcome : std::uint8_t {
  kNoCandidate,    ///< No vision patch in the ring sector.
  kNoCorrelation,  ///< No candidate's descriptor correlates.
  kNoNeighbours,   ///< No candidate's neighbourhood is similar.
  kNoBoundary,     ///< Too little boundary (hybrid: facade), or the 2D NDT found no minimum.
  kRejected3d,     ///< The 3D NDT did not converge near the 2D pose.
  kOutOfWindow,    ///< Hybrid: moves further from the pose than patches may.
  kPose,           ///< Gave a pose outside the largest cluster.
  kInCluster,      ///< Gave a pose of the largest cluster.
};
[[nodiscard]] std::string_view to_string(PatchOutcome outcome);

/// One LiDAR patch on its way to a pose (HybridFusion Algorithm 1).
struct PatchMatch {
  Eigen::Vector2i lidar_cell = Eigen::Vector2i::Zero();          ///< Column and row in its grid.
  Eigen::Vector3d centroid_in_vision = Eigen::Vector3d::Zero();  ///< By the coarse pose [m].
  std::size_t num_points = 0;
  std::size_t num_candidates = 0;  ///< In the ring sector.
  std::size_t num_correlated = 0;  ///< Of these after the descriptor filter.
  std::size_t num_similar = 0;     ///< Of these after the neighbour filter.
  PatchOutcome outcome = PatchOutcome::kNoCandidate;
  Eigen::Vector2i vision_cell = Eigen::Vector2i::Constant(-1);  ///< Best candidate; -1 without one.
  double correlation = 0.0;                                     ///< Pearson, of the best candidate.
  double neighbour_score = 0.0;                                 ///< Of the best candidate.
  double score_2d_m = 0.0;           ///< Mean distance of the boundaries after the 2D NDT.
  double score_3d_m = 0.0;           ///< Median distance to the candidate after the 3D NDT.
  Rigid3 vision_from_lidar_2d = {};  ///< After the 2D NDT; identity where it was not reached.
  Rigid3 vision_from_lidar = {};  ///< T_patch times the coarse pose; the coarse pose without one.
};

}  // namespace hybridfusion
