#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/registration/gap_interpolation.hpp>

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Measured points and how they are asked for.
struct Measured {
  const PointCloud& cloud;
  const KdTree& tree;
  const InterpolationOptions& options;

  [[nodiscard]] float spacing_squared() const {
    return static_cast<float>(options.spacing_m * options.spacing_m);
  }
};

/// Plane through the neighbours of a place, near ones weighing more.
struct LocalPlane {
  Eigen::Vector3d mean;
  Eigen::Vector3d normal;
  Eigen::Vector3d along;  ///< With `across` a basis of the plane.
  Eigen::Vector3d across;
  double roughness_m = 0.0;
};

/// Weight of a neighbour: a Gaussian with half the radius as deviation.
[[nodiscard]] double weight_of(const Neighbor& member, double radius_m);

/// Neighbours within the radius, nearest first; false when they are too few for a surface.
[[nodiscard]] bool find_neighbors(const Measured& measured,
                                  const Eigen::Vector3f& at,
                                  std::vector<Neighbor>& members);

/// None where the neighbours lie along a line or rougher than allowed. @pre !members.empty()
[[nodiscard]] std::optional<LocalPlane> local_plane(const Measured& measured,
                                                    const std::vector<Neighbor>& members);

}  // namespace hybridfusion
