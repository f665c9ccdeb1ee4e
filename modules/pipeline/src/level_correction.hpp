#pragma once

#include "json_text.hpp"

#include <hybridfusion/registration/register_cross_source.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace hybridfusion {

/// What the workspaces around two clouds know of their verticals. Photos with GNSS alone leave the
/// tilt of their model to the heights of a few dozen fixes; an IMU senses it.
struct LevelEvidence {
  std::optional<double> lidar_sigma_rad = {};          ///< lidar/level.json.
  std::optional<double> vision_sigma_rad = {};         ///< vision/pose_covariance.csv.
  std::optional<Eigen::Vector3d> cameras_middle = {};  ///< Mean projection centre, in vision [m].
};

/// @param covariances  pose_covariance.csv with the COLMAP model beside it, when there is one.
/// @param level        level.json, when there is one.
/// @returns kParse naming the file that cannot be read.
[[nodiscard]] Expected<LevelEvidence> read_level_evidence(
    const std::optional<std::filesystem::path>& covariances,
    const std::optional<std::filesystem::path>& level);

/// How the frame of the fused cloud stands to that of the photo model.
struct LevelCorrection {
  bool applied = false;
  double tilt_rad = 0.0;          ///< Of the photo model against the LiDAR map's vertical.
  double lidar_sigma_rad = 0.0;   ///< Of gravity in vision: the map's and the pose's.
  double vision_sigma_rad = 0.0;  ///< Of the photo model's own vertical.
  std::string reason = {};        ///< Why it was not applied.
  Rigid3 level_from_vision = {};  ///< Identity when not applied.
};

/// The least turn that makes the LiDAR map's vertical that of the fused cloud, about the middle of
/// the cameras: position and heading stay as GNSS gave them. Applied when the LiDAR map knows the
/// vertical at least twice as well as the photo model and both agree within what the two allow.
[[nodiscard]] LevelCorrection level_correction(const RegistrationResult& result,
                                               const LevelEvidence& evidence);

[[nodiscard]] Json json_of(const LevelCorrection& level);

}  // namespace hybridfusion
