#pragma once

#include <hybridfusion/pipeline/stages.hpp>
#include <hybridfusion/registration/register_cross_source.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace hybridfusion {

/// What is known of vision_from_lidar before the clouds are compared.
struct CoarsePose {
  std::optional<Rigid3> vision_from_lidar = {};
  std::optional<PoseCovariance> covariance = {};
  double max_yaw_rad = 0.0;  ///< How far the heading is to be searched.
  std::string source = {};   ///< For a person: where it comes from.
};

/// In this order: a given transform; GNSS on both sides (origin.json beside G, gnss.json beside L);
/// the identity when the caller bounds it; nothing, and then every heading is searched.
[[nodiscard]] Expected<CoarsePose> coarse_pose(
    const RegisterInputs& inputs,
    const std::optional<std::filesystem::path>& vision_origin,
    const std::optional<std::filesystem::path>& lidar_gnss,
    const RegistrationOptions& options);

}  // namespace hybridfusion
