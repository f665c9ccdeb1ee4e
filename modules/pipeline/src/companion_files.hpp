#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// `name` in the folder of `file`, when it is a file there.
[[nodiscard]] std::optional<std::filesystem::path> beside(const std::filesystem::path& file,
                                                          std::string_view name);

/// Files of the workspaces around the two clouds that help, when they exist.
struct Companions {
  std::optional<std::filesystem::path> trajectory = {};  ///< Beside L.
  std::optional<std::filesystem::path> gnss = {};        ///< Beside L.
  std::optional<std::filesystem::path> level = {};       ///< Beside L.
  std::optional<std::filesystem::path> origin = {};      ///< Beside G.
  std::optional<std::filesystem::path> covariance = {};  ///< Beside G.
};

[[nodiscard]] Companions companions_of(const RegisterInputs& inputs);

/// Positions of the drive in the LiDAR map; empty without a trajectory.
/// @returns The error of a trajectory that cannot be read.
[[nodiscard]] Expected<std::vector<Eigen::Vector3d>> sensor_positions(const Companions& companions);

}  // namespace hybridfusion
