#include "gnss_difference.hpp"

#include "photo_places.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

Eigen::AlignedBox3d box_of(const PointCloud& cloud) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : cloud.points) {
    if (point.allFinite()) box.extend(point.cast<double>());
  }
  return box;
}

Eigen::Vector3d sigma_of(const PoseCovariance& covariance) {
  return covariance.diagonal().head<3>().cwiseSqrt();
}

}  // namespace

std::optional<std::string> sites_apart(const PointCloud& vision,
                                       const PointCloud& lidar,
                                       const CoarsePose& coarse,
                                       double max_sigma) {
  if (!coarse.vision_from_lidar || !coarse.covariance) return std::nullopt;
  const Eigen::AlignedBox3d vision_box = box_of(vision);
  const Eigen::AlignedBox3d lidar_box = box_of(lidar);
  if (vision_box.isEmpty() || lidar_box.isEmpty()) return std::nullopt;
  const Eigen::Vector3d lidar_centre = *coarse.vision_from_lidar * lidar_box.center();
  const double centres_m = (vision_box.center() - lidar_centre).head<2>().norm();
  const double reach_m = 0.5 * (vision_box.diagonal().norm() + lidar_box.diagonal().norm());
  const double limit_m = max_sigma * sigma_of(*coarse.covariance).head<2>().maxCoeff();
  if (centres_m - reach_m <= limit_m) return std::nullopt;
  return fmt::format(
      "by their GNSS the photo cloud and the LiDAR cloud lie {} apart and reach {}; check that "
      "both "
      "are of one place (hybridfusion doctor compares the two)",
      distance_text(centres_m),
      distance_text(reach_m));
}

std::optional<GnssDifference> gnss_difference(
    const CoarsePose& coarse,
    const Rigid3& vision_from_lidar,
    const std::vector<Eigen::Vector3d>& sensor_positions) {
  if (!coarse.vision_from_lidar || !coarse.covariance) return std::nullopt;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& at : sensor_positions) {
    middle += at / static_cast<double>(sensor_positions.size());
  }
  GnssDifference result{
      .difference_m = vision_from_lidar * middle - *coarse.vision_from_lidar * middle,
      .sigma_m = sigma_of(*coarse.covariance)};
  constexpr double kSigmas = 2.0;
  result.beyond = (result.difference_m.cwiseAbs().array() > kSigmas * result.sigma_m.array()).any();
  const Eigen::Vector3d& d = result.difference_m;
  result.text = fmt::format(
      "the GNSS of the vehicle lies {:.1f} m {}, {:.1f} m {} and {:.1f} m {} of where the photos' "
      "GNSS puts it",
      std::abs(d.x()),
      d.x() > 0.0 ? "west" : "east",
      std::abs(d.y()),
      d.y() > 0.0 ? "south" : "north",
      std::abs(d.z()),
      d.z() > 0.0 ? "below" : "above");
  if (result.beyond) {
    result.text += fmt::format(
        ", more than two deviations ({:.0f} m horizontal, {:.0f} m vertical): one of the two may "
        "count heights from sea level, or its base may be wrong",
        result.sigma_m.x(),
        result.sigma_m.z());
  }
  return result;
}

}  // namespace hybridfusion
