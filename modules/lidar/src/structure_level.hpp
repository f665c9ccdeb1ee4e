#pragma once

#include "segments.hpp"

#include <hybridfusion/core/run_context.hpp>

#include <optional>

namespace hybridfusion {

struct StructureLevel {
  Eigen::Vector3d up_in_map = Eigen::Vector3d::UnitZ();
  double sigma_rad = 0.0;
  /// Level faces lie above the LiDAR, not below it: what was taken for up is down.
  bool upside_down = false;
};

/// The vertical as buildings and ground show it: walls stand upright, ground lies about level.
/// Walls decide where they face two directions; along a wall the ground does, which may slope.
/// @param about_up_in_map  Right to 45 degrees.
/// @returns nothing when neither is seen; kIo, kCancelled.
[[nodiscard]] Expected<std::optional<StructureLevel>> level_by_structure(
    const ScanStore& store,
    const std::vector<Segment>& segments,
    const Eigen::Vector3d& about_up_in_map,
    const RunContext& ctx);

/// A plane of the map, with the weight of its points.
struct MapFace {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d center_m = Eigen::Vector3d::Zero();
  double weight = 0.0;
  Eigen::Vector3d from_lidar_m = Eigen::Vector3d::Zero();  ///< Zero: not known.
};
[[nodiscard]] std::optional<StructureLevel> level_by_faces(std::span<const MapFace> faces,
                                                           const Eigen::Vector3d& about_up);

}  // namespace hybridfusion
