#pragma once

#include "map_search.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace hybridfusion {

/// Map points in a flat open-addressing hash of cells of 2 x 2 x 2 voxels. A voxel holds one point:
/// the running mean of the first 100 that were inserted into it. Memory: 144 bytes a cell, about 4
/// points a cell on surfaces.
class VoxelMap {
 public:
  /// @pre voxel_m > 0
  explicit VoxelMap(double voxel_m);

  /// Points are ignored beyond +-2^20 cells and when not finite.
  void insert(std::span<const Eigen::Vector3f> points);
  /// The `count` nearest points strictly nearer than `radius_m`. @pre 0 < count <= kCapacity
  void nearest(const Eigen::Vector3f& query,
               int count,
               float radius_m,
               MapNeighbors& neighbors) const;
  /// Goes through the whole map, whatever the size of the box.
  void erase_box(const MapBox& box);
  /// Drops the points outside the closed cube, and gives their memory back.
  void erase_outside(const Eigen::Vector3f& center, float half_side_m);

  [[nodiscard]] std::size_t size() const { return num_points_; }
  [[nodiscard]] std::size_t num_bytes() const;
  /// All points, in order of their cells' first insertion.
  [[nodiscard]] std::vector<Eigen::Vector3f> points() const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Cell {
    std::uint64_t key = 0;
    std::array<Eigen::Vector3f, 8> points = {};
    std::array<std::uint8_t, 8> counts = {};  // 0: empty
  };

  /// Of the table; the tag tells most other cells apart without a look at them.
  struct Slot {
    std::uint32_t tag = 0;
    std::uint32_t cell = kNone;
  };
  struct Search;
  /// Where a point goes.
  struct Target {
    Eigen::Vector3f point = Eigen::Vector3f::Zero();
    std::uint64_t key = 0;
    int slot = 0;            // in its cell
    std::uint32_t cell = 0;  // its index
  };

  void add(const Target& target);
  void search_nearest_cells(Search& search) const;
  void search_ring(int ring, Search& search) const;
  void search_cell(const Eigen::Vector3i& offset, Search& search) const;
  template <class Predicate>
  void erase_points(const Predicate& goes);
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const;
  std::uint32_t find_or_add(std::uint64_t key);
  void rehash(std::size_t num_slots);

  float voxel_m_;
  float inverse_cell_;
  std::vector<Slot> slots_;
  std::vector<Cell> cells_;
  std::size_t num_points_ = 0;
};

}  // namespace hybridfusion
