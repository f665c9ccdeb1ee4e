#pragma once

#include <hybridfusion/core/point_cloud.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Weighted sums of the depths that fall into one voxel: 48 bytes, of which a city takes millions.
struct VoxelSums {
  std::uint64_t key = 0;
  Eigen::Vector3f offset = Eigen::Vector3f::Zero();  ///< From the voxel's corner, weighted.
  float weight = 0.0F;
  Eigen::Vector3f towards_photo = Eigen::Vector3f::Zero();
  std::int32_t count = 0;
  std::uint64_t colors = 0;  ///< Sums of red, green and blue, 21 bits each.

  /// Counts a depth of this colour.
  void count_color(const Rgb8& color);
  /// Of the depths counted, the first 8192 if there are more.
  [[nodiscard]] Rgb8 mean_color() const;
};
static_assert(sizeof(VoxelSums) == 48);

/// Sums by voxel key in order of first use: open addressing over indices into blocks that never
/// move, so that growing copies no sums.
class VoxelTable {
 public:
  [[nodiscard]] VoxelSums& operator[](std::uint64_t key);
  /// Frees what operator[] alone needs, a fifth of the memory. After it the sums can only be
  /// visited.
  void close();
  [[nodiscard]] std::size_t size() const { return size_; }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t i = 0; i < size_; ++i) visit(entry(i));
  }

 private:
  // Larger than what glibc's allocator ever takes from its heap (32 MiB): between the voxels, which
  // stay, it would keep the freed memory of photos and maps. Pages not yet used take none.
  static constexpr std::size_t kBlockSize = 1U << 20U;
  static constexpr std::uint32_t kEmpty = 0xffffffffU;

  [[nodiscard]] VoxelSums& entry(std::size_t i) { return blocks_[i / kBlockSize][i % kBlockSize]; }
  [[nodiscard]] const VoxelSums& entry(std::size_t i) const {
    return blocks_[i / kBlockSize][i % kBlockSize];
  }
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  void grow();

  std::vector<std::vector<VoxelSums>> blocks_ = {};  // each with room for kBlockSize
  std::vector<std::uint32_t> slots_ = {};            // a power of two
  std::size_t size_ = 0;
  bool is_closed_ = false;
};

}  // namespace hybridfusion
