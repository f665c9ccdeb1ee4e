#pragma once

#include "dense_map.hpp"

#include <map>
#include <utility>

namespace hybridfusion {

/// A point on its way into the dense map.
struct TilePoint {
  float x = 0.0F;  ///< In the map [m].
  float y = 0.0F;
  float z = 0.0F;
  float intensity = 0.0F;
  float time_s = 0.0F;  ///< Since the first scan.
  std::uint32_t scan = 0;
};

/// Map points by square tiles of the plan, put aside in a spill file. Points within kSupportReach
/// voxels of a border go to both sides, so that each tile sees the neighbours of its voxels.
class DenseTiles {
 public:
  DenseTiles(double voxel_m, SpillFile spill);

  /// @returns kIo.
  [[nodiscard]] Expected<void> add(const TilePoint& point);
  struct Tile {
    std::vector<TilePoint> open = {};
    std::vector<SpillFile::Block> blocks = {};
  };
  /// Tiles by their plan index (x, y), in ascending order.
  [[nodiscard]] const std::map<std::pair<int, int>, Tile>& tiles() const { return tiles_; }
  [[nodiscard]] PlanBox box_of(const std::pair<int, int>& tile) const;
  /// Centre of a tile in the map [m].
  [[nodiscard]] Eigen::Vector2d center_of(const std::pair<int, int>& tile) const;
  /// Calls `visit` with the points of a tile in the order of add(). @returns kIo.
  template <class Visit>
  [[nodiscard]] Expected<void> for_each(const Tile& tile, Visit&& visit) const;

 private:
  [[nodiscard]] Expected<void> put_aside(Tile& tile);
  [[nodiscard]] Expected<std::vector<TilePoint>> read(const SpillFile::Block& block) const;

  double voxel_m_;
  SpillFile spill_;
  std::map<std::pair<int, int>, Tile> tiles_ = {};
  std::size_t num_open_ = 0;
};

template <class Visit>
Expected<void> DenseTiles::for_each(const Tile& tile, Visit&& visit) const {
  for (const SpillFile::Block& block : tile.blocks) {
    HF_TRY(const std::vector<TilePoint> points, read(block));
    for (const TilePoint& point : points) visit(point);
  }
  for (const TilePoint& point : tile.open) visit(point);
  return {};
}

}  // namespace hybridfusion
