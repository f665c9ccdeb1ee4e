#pragma once

#include <hybridfusion/geometry/boundary.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/registration/gridding.hpp>
#include <hybridfusion/registration/ndt.hpp>
#include <hybridfusion/registration/paper_options.hpp>

#include <optional>
#include <span>
#include <vector>

namespace hybridfusion {

/// 2D boundary of what stands higher than h in a patch and its neighbours (Algorithm 1,
/// project2D_get_boundary_points). @param heights  Above ground [m], one per point.
[[nodiscard]] std::vector<Eigen::Vector2f> splice_boundary(std::span<const Eigen::Vector3f> points,
                                                           std::span<const float> heights,
                                                           const PatchGrid& grid,
                                                           std::size_t patch,
                                                           const BoundaryOptions& options);

/// The boundary of a candidate, ready to be registered to. Not empty.
class BoundaryTarget {
 public:
  explicit BoundaryTarget(std::vector<Eigen::Vector2f> boundary);

  [[nodiscard]] std::span<const Eigen::Vector2f> points() const { return points_; }
  [[nodiscard]] const Eigen::Vector2d& centroid() const { return centroid_; }
  /// Mean distance of the moved points to the nearest boundary point [m].
  [[nodiscard]] double mean_distance_m(std::span<const Eigen::Vector2f> source,
                                       const Rigid2& target_from_source) const;

 private:
  std::vector<Eigen::Vector2f> points_;
  std::vector<Eigen::Vector3f> flat_;  ///< z = 0, for the tree.
  KdTree tree_;
  Eigen::Vector2d centroid_;
};

struct BoundaryMatch {
  Rigid2 target_from_source = {};
  double mean_distance_m = 0.0;
};

/// 2D NDT of a LiDAR boundary to a candidate's, once from where the coarse pose puts it and once
/// from centroid on centroid; the pose with the smaller mean distance wins (HybridFusion III-C.4).
/// @returns nothing when neither start reaches a minimum.
[[nodiscard]] std::optional<BoundaryMatch> align_boundaries_2d(
    std::span<const Eigen::Vector2f> lidar,
    const BoundaryTarget& vision,
    const PaperOptions& options);

}  // namespace hybridfusion
