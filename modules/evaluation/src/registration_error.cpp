#include "statistics.hpp"

#include <hybridfusion/evaluation/registration_error.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Positions of the drive about every metre, at height 0: the distance to the path is horizontal.
std::vector<Eigen::Vector3f> flat_path(const Trajectory& trajectory) {
  std::vector<Eigen::Vector3f> path;
  for (const StampedPose& pose : trajectory.poses) {
    const Eigen::Vector3f position(static_cast<float>(pose.map_from_body.translation.x()),
                                   static_cast<float>(pose.map_from_body.translation.y()),
                                   0.0F);
    if (path.empty() || (position - path.back()).norm() > 1.0F) path.push_back(position);
  }
  return path;
}

std::optional<Rigid3> truth_from_map_at(const DrivenMap& driven, std::size_t point) {
  if (driven.map.times_s.empty()) return driven.truth_from_map;
  const Timestamp time = from_seconds(driven.map.times_s[point]);
  constexpr double kMaxExtrapolation_s = 0.2;  // a scan period beyond the last pose
  const auto truth_from_body = interpolate(driven.truth, time, kMaxExtrapolation_s);
  const auto map_from_body = interpolate(driven.estimate, time, kMaxExtrapolation_s);
  if (!truth_from_body || !map_from_body) return std::nullopt;
  return *truth_from_body * map_from_body->inverse();
}

}  // namespace

Expected<ScenePlaces> true_places(const DrivenMap& driven,
                                  double radius_m,
                                  std::size_t max_points) {
  HF_CHECK(radius_m > 0.0 && max_points > 0);
  const std::vector<Eigen::Vector3f> path = flat_path(driven.estimate);
  const KdTree tree(path);
  const auto limit_m2 = static_cast<float>(radius_m * radius_m);
  ScenePlaces places;
  const std::size_t stride = (driven.map.size() + max_points - 1) / max_points;
  for (std::size_t i = 0; i < driven.map.size(); i += stride) {
    const Eigen::Vector3f& point = driven.map.points[i];
    if (!point.allFinite()) continue;
    if (tree.nearest({point.x(), point.y(), 0.0F}).squared_distance_m2 > limit_m2) continue;
    const auto truth_from_map = truth_from_map_at(driven, i);
    if (!truth_from_map) continue;
    places.points_in_map.emplace_back(point.cast<double>());
    places.points_in_truth.push_back(*truth_from_map * point.cast<double>());
  }
  if (places.points_in_map.size() < 3) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("only {} of {} LiDAR points lie within {} m of the drive at a time "
                            "that the truth covers",
                            places.points_in_map.size(),
                            driven.map.size(),
                            radius_m));
  }
  return places;
}

Expected<SceneTruth> registration_truth(const ScenePlaces& places, const Sim3& truth_from_vision) {
  const Sim3 vision_from_truth = truth_from_vision.inverse();
  std::vector<Eigen::Vector3d> points_in_vision;
  SceneTruth result{.num_points = places.points_in_map.size()};
  for (std::size_t i = 0; i < places.points_in_map.size(); ++i) {
    points_in_vision.push_back(vision_from_truth * places.points_in_truth[i]);
    result.centroid_in_lidar += places.points_in_map[i];
  }
  result.centroid_in_lidar /= static_cast<double>(result.num_points);
  HF_TRY(result.vision_from_lidar, fit_rigid3(points_in_vision, places.points_in_map));
  HF_TRY(const Sim3 similarity, fit_sim3(points_in_vision, places.points_in_map));
  result.scale_error = similarity.scale - 1.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < points_in_vision.size(); ++i) {
    sum += (points_in_vision[i] - result.vision_from_lidar * places.points_in_map[i]).squaredNorm();
  }
  result.floor_rmse_m = std::sqrt(sum / static_cast<double>(result.num_points));
  return result;
}

RegistrationErrors registration_errors(const Rigid3& true_vision_from_lidar,
                                       const Rigid3& vision_from_lidar,
                                       const Eigen::Vector3d& centroid_in_lidar) {
  const Rigid3 error = true_vision_from_lidar.inverse() * vision_from_lidar;
  const Eigen::Vector3d shift = error * centroid_in_lidar - centroid_in_lidar;
  return {.at_centroid_m = shift.norm(),
          .horizontal_m = shift.head<2>().norm(),
          .vertical_m = shift.z(),
          .rotation_deg =
              to_deg(rotation_distance_rad(error.rotation, Eigen::Quaterniond::Identity()))};
}

Eigen::Vector3d centroid(const PointCloud& cloud) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (const Eigen::Vector3f& point : cloud.points) {
    if (!point.allFinite()) continue;
    sum += point.cast<double>();
    ++count;
  }
  return count == 0 ? sum : sum / static_cast<double>(count);
}

}  // namespace hybridfusion
