#pragma once

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <span>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Local shape from the covariance of a neighbourhood.
struct PointShape {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< Unit, sign arbitrary; zero if degenerate.
  float curvature = 1.0F;  ///< Smallest eigenvalue over the sum: 0 flat, 1/3 a ball.
};

/// Covariance (divided by the count) about the mean; the mean is returned in `mean`.
[[nodiscard]] Eigen::Matrix3d covariance_of(std::span<const Eigen::Vector3f> points,
                                            std::span<const Neighbor> members,
                                            Eigen::Vector3d& mean);

/// Shape of a neighbourhood; degenerate for fewer than three members.
[[nodiscard]] PointShape shape_of(std::span<const Eigen::Vector3f> points,
                                  std::span<const Neighbor> members);

/// Shape at each point from its `num_neighbors` nearest ones. @pre num_neighbors >= 3
[[nodiscard]] std::vector<PointShape> estimate_shapes(std::span<const Eigen::Vector3f> points,
                                                      const KdTree& tree,
                                                      int num_neighbors,
                                                      const RunContext& ctx = {});

}  // namespace hybridfusion
