#pragma once

#include "depth_map.hpp"

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Some columns of a band of rows, and the block of space that holds their points.
struct DepthTile {
  int begin_x = 0;
  int end_x = 0;
  /// In the map's camera frame [m]: the rays of the corners between the smallest and the largest
  /// depth. Nothing for a tile without depths.
  std::optional<std::array<Eigen::Vector3f, 8>> corners = {};
};

/// The rows [first_row, end_row) of a map, from left to right.
[[nodiscard]] std::vector<DepthTile> tiles_of_rows(const DepthMap& map, int first_row, int end_row);

/// False only when no point of the convex block between the corners (in the camera frame of `grid`)
/// lies in front of the camera and within two pixels of the grid.
[[nodiscard]] bool may_see(const PinholeGrid& grid, const std::array<Eigen::Vector3f, 8>& corners);

}  // namespace hybridfusion
