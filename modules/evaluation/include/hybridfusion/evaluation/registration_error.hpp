#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/core/trajectory.hpp>

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// What the LiDAR module delivered and where the vehicle truly was, both of the same body.
struct DrivenMap {
  const PointCloud& map;       ///< L, with times_s when it has them.
  const Trajectory& estimate;  ///< map_from_body.
  const Trajectory& truth;     ///< truth_from_body.
  Rigid3 truth_from_map = {};  ///< Best rigid alignment of the trajectory.
};

/// Points of L and the places in the world that they show.
struct ScenePlaces {
  std::vector<Eigen::Vector3d> points_in_map = {};
  std::vector<Eigen::Vector3d> points_in_truth = {};
};

/// True places of the points of L within `radius_m` (horizontally) of the estimated path, thinned
/// to at most `max_points` evenly over the cloud. With point times each point rides on the true
/// pose of its scan, so drift of the map is charged to the map; without, L moves as one body.
/// @returns kInsufficient when fewer than 3 points remain.
[[nodiscard]] Expected<ScenePlaces> true_places(const DrivenMap& driven,
                                                double radius_m,
                                                std::size_t max_points);

/// The rigid transform a perfect registration would return. Truth is defined at the scene, not at
/// the cameras: a scale error of the photo model, seen from cameras 65 m up, would charge a
/// perfect fit decimetres of height.
struct SceneTruth {
  Rigid3 vision_from_lidar = {};
  Eigen::Vector3d centroid_in_lidar = Eigen::Vector3d::Zero();  ///< Of the points used [m].
  double floor_rmse_m = 0.0;  ///< What no rigid transform can remove (scale, drift).
  double scale_error = 0.0;   ///< Size of G over size of L at the scene - 1.
  std::size_t num_points = 0;
};

/// @param truth_from_vision  Similarity that takes estimated camera centres to true ones.
[[nodiscard]] Expected<SceneTruth> registration_truth(const ScenePlaces& places,
                                                      const Sim3& truth_from_vision);

/// `E = inverse(true) * estimated`, judged in the LiDAR map frame (z up).
struct RegistrationErrors {
  double at_centroid_m = 0.0;
  double horizontal_m = 0.0;
  double vertical_m = 0.0;  ///< Signed: positive when the estimate puts L too high.
  double rotation_deg = 0.0;

  [[nodiscard]] bool success() const { return at_centroid_m < 1.0 && rotation_deg < 2.0; }
  [[nodiscard]] bool precise() const { return at_centroid_m < 0.10 && rotation_deg < 0.2; }
};

[[nodiscard]] RegistrationErrors registration_errors(const Rigid3& true_vision_from_lidar,
                                                     const Rigid3& vision_from_lidar,
                                                     const Eigen::Vector3d& centroid_in_lidar);

/// Mean of the finite points; zero for none.
[[nodiscard]] Eigen::Vector3d centroid(const PointCloud& cloud);

}  // namespace hybridfusion
