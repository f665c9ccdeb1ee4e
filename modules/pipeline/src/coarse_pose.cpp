#include "coarse_pose.hpp"

#include "workspace_data.hpp"

#include <hybridfusion/io/transform_json.hpp>

#include <cmath>
#include <numbers>

namespace hybridfusion {
namespace {

// Constant parts of two independent code receivers: horizontally a few metres, vertically more
// (biases of 6 m are seen); both clouds are level to about a degree.
constexpr double kGnssSigmaHorizontal_m = 3.0;
constexpr double kGnssSigmaVertical_m = 8.0;
constexpr double kLevelSigma_rad = std::numbers::pi / 180.0;
PoseCovariance gnss_covariance(double heading_sigma_rad) {
  Eigen::Matrix<double, 6, 1> sigmas;
  sigmas << kGnssSigmaHorizontal_m, kGnssSigmaHorizontal_m, kGnssSigmaVertical_m, kLevelSigma_rad,
      kLevelSigma_rad, std::hypot(heading_sigma_rad, kLevelSigma_rad);
  return sigmas.cwiseAbs2().asDiagonal();
}

}  // namespace

Expected<CoarsePose> coarse_pose(const RegisterInputs& inputs,
                                 const std::optional<std::filesystem::path>& vision_origin,
                                 const std::optional<std::filesystem::path>& lidar_gnss,
                                 const RegistrationOptions& options) {
  CoarsePose pose{.max_yaw_rad = options.max_yaw_rad};
  if (inputs.initial) {
    HF_TRY(pose.vision_from_lidar, read_transform_json(*inputs.initial, "vision_from_lidar"));
    pose.source = "given transform";
    return pose;
  }
  if (vision_origin && lidar_gnss) {
    HF_TRY(const GeodeticOrigin origin, read_origin(*vision_origin));
    HF_TRY(const MapGeoreference map, read_map_georeference(*lidar_gnss));
    pose.vision_from_lidar = enu_from_enu(origin, map.origin) * map.enu_from_map;
    pose.covariance = gnss_covariance(map.heading_sigma_rad);
    pose.source = "GNSS of photos and vehicle";
    return pose;
  }
  if (inputs.near_identity) {
    pose.vision_from_lidar = Rigid3{};
    pose.source = "identity within the given limits";
    return pose;
  }
  pose.max_yaw_rad = std::numbers::pi;
  pose.source = "none, every heading and offset is searched";
  return pose;
}

}  // namespace hybridfusion
