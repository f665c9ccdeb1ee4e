#include "companion_files.hpp"

#include <hybridfusion/io/tum.hpp>

#include <system_error>

namespace hybridfusion {

std::optional<std::filesystem::path> beside(const std::filesystem::path& file,
                                            std::string_view name) {
  const std::filesystem::path path = file.parent_path() / name;
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return std::nullopt;
  return path;
}

Companions companions_of(const RegisterInputs& inputs) {
  Companions found = {.trajectory = beside(inputs.lidar, "trajectory.tum"),
                      .gnss = beside(inputs.lidar, "gnss.json"),
                      .level = beside(inputs.lidar, "level.json"),
                      .origin = beside(inputs.vision, "origin.json"),
                      .covariance = beside(inputs.vision, "pose_covariance.csv")};
  // Without the poses the covariances say nothing.
  if (!beside(inputs.vision, "images.txt")) found.covariance.reset();
  return found;
}

Expected<std::vector<Eigen::Vector3d>> sensor_positions(const Companions& companions) {
  std::vector<Eigen::Vector3d> positions;
  if (!companions.trajectory) return positions;
  HF_TRY(const Trajectory trajectory, read_tum(*companions.trajectory));
  for (const StampedPose& pose : trajectory.poses) {
    positions.push_back(pose.map_from_body.translation);
  }
  return positions;
}

}  // namespace hybridfusion
