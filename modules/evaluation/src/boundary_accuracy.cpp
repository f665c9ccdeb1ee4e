#include <hybridfusion/evaluation/boundary_accuracy.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>

#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Eigen::Vector3f flat(const Eigen::Vector2f& point) {
  return {point.x(), point.y(), 0.0F};
}

}  // namespace

Expected<std::vector<Eigen::Vector2f>> standing_boundary(std::span<const Eigen::Vector3f> points,
                                                         const BoundaryAccuracyOptions& options,
                                                         const RunContext& ctx) {
  HF_TRY(const GroundModel ground, fit_ground(points, options.ground));
  std::vector<Eigen::Vector2f> boundary = elevated_boundary(points, ground, options.boundary, ctx);
  if (boundary.empty()) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("nothing stands higher than {} m above the ground",
                            options.boundary.min_height_m));
  }
  return boundary;
}

BoundaryAccuracy boundary_accuracy(std::span<const Eigen::Vector2f> vision_boundary,
                                   std::span<const Eigen::Vector2f> lidar_boundary,
                                   double partner_m) {
  HF_CHECK(!vision_boundary.empty() && !lidar_boundary.empty() && partner_m > 0.0);
  std::vector<Eigen::Vector3f> vision;
  vision.reserve(vision_boundary.size());
  for (const Eigen::Vector2f& point : vision_boundary) vision.push_back(flat(point));
  const KdTree tree(vision);
  Eigen::Vector2f low = vision_boundary.front();
  Eigen::Vector2f high = low;
  for (const Eigen::Vector2f& point : vision_boundary) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Array2f margin = Eigen::Array2f::Constant(static_cast<float>(partner_m));
  BoundaryAccuracy result{.num_vision = vision_boundary.size()};
  double sum = 0.0;
  double trimmed_sum = 0.0;
  std::size_t partners = 0;
  for (const Eigen::Vector2f& point : lidar_boundary) {
    if ((point.array() < low.array() - margin).any() ||
        (point.array() > high.array() + margin).any()) {
      continue;
    }
    ++result.num_lidar;
    const float distance_m = std::sqrt(tree.nearest(flat(point)).squared_distance_m2);
    result.distances_m.push_back(distance_m);
    sum += distance_m;
    if (distance_m > partner_m) continue;
    trimmed_sum += distance_m;
    ++partners;
  }
  result.num_outside = lidar_boundary.size() - result.num_lidar;
  if (result.num_lidar == 0) {
    result.mean_m = result.trimmed_mean_m = std::nan("");
    return result;
  }
  result.mean_m = sum / static_cast<double>(result.num_lidar);
  result.share_with_partner = static_cast<double>(partners) / static_cast<double>(result.num_lidar);
  result.trimmed_mean_m =
      partners == 0 ? std::nan("") : trimmed_sum / static_cast<double>(partners);
  return result;
}

}  // namespace hybridfusion
