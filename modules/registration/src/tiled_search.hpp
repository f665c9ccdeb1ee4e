#pragma once

#include "hybrid.hpp"

#include <span>

namespace hybridfusion {

/// When and how a vision cloud is searched piece by piece.
struct TileOptions {
  double max_area_m2 = 1e6;  ///< Searched at once.
  double tile_m = 500.0;     ///< Largest side of a tile without the margin that L needs around it.
  int halvings = 1;          ///< Of the rasters of the exhaustive search, against search_cell_m.
  std::size_t max_tiles = 400;
};

/// Whether the points cover more than may be searched at once.
[[nodiscard]] bool needs_tiles(std::span<const Eigen::Vector3f> vision,
                               const OutlineOptions& options,
                               const TileOptions& tiles = {});

/// find_places over a vision cloud of any extent: tile by tile with as much margin as L needs, the
/// places of all tiles in one list, so that each competes with every other. Memory is that of one
/// tile, time grows with the area.
/// @param clouds  The LiDAR half; its vision half is used for the tiles and left empty.
/// @returns kDegenerate when there is no facade or no tile with a place, kInsufficient for more
/// than `max_tiles` tiles, kCancelled.
[[nodiscard]] Expected<OutlinePlaces> find_places_in_tiles(std::span<const Eigen::Vector3f> vision,
                                                           const RegistrationInput& input,
                                                           const RegistrationOptions& options,
                                                           const TileOptions& tiles,
                                                           const RunContext& ctx,
                                                           PreparedClouds& clouds);

/// register_hybrid by tiles: the vision cloud is prepared once more about the best place.
[[nodiscard]] Expected<RegistrationResult> register_in_tiles(
    std::span<const Eigen::Vector3f> vision,
    PreparedClouds clouds,
    const PointCloud& lidar,
    const RegistrationInput& input,
    const RegistrationOptions& options,
    const RunContext& ctx,
    const TileOptions& tiles = {});

}  // namespace hybridfusion
