#pragma once

#include "coarse_pose.hpp"

#include <hybridfusion/core/point_cloud.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hybridfusion {

/// Why the clouds cannot be of one place by the GNSS of photos and vehicle; nothing where they can,
/// or where it is not known.
/// @param max_sigma  Of the deviations of the coarse pose by which they may miss each other.
[[nodiscard]] std::optional<std::string> sites_apart(const PointCloud& vision,
                                                     const PointCloud& lidar,
                                                     const CoarsePose& coarse,
                                                     double max_sigma);

/// Where the registration puts the vehicle less where GNSS does, east-north-up [m]: the difference
/// of the two receivers, and of what their heights count from.
struct GnssDifference {
  Eigen::Vector3d difference_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Zero();  ///< Of the coarse pose.
  std::string text = {};                              ///< For a person.
  bool beyond = false;                                ///< More than two deviations on an axis.
};

/// Nothing where the coarse pose is not by GNSS.
[[nodiscard]] std::optional<GnssDifference> gnss_difference(
    const CoarsePose& coarse,
    const Rigid3& vision_from_lidar,
    const std::vector<Eigen::Vector3d>& sensor_positions);

}  // namespace hybridfusion
