#pragma once

#include <hybridfusion/core/point_cloud.hpp>

#include <cstdint>

#include <Eigen/Core>

namespace hybridfusion {

/// Cell of a regular grid anchored at the origin.
using VoxelIndex = Eigen::Vector3i;

[[nodiscard]] inline VoxelIndex voxel_of(const Eigen::Vector3f& point, double voxel_m) {
  return (point.cast<double>() / voxel_m).array().floor().cast<int>();
}

/// 21 bits an axis, so that cells sort and hash as one integer; valid for |index| < 2^20.
[[nodiscard]] inline std::uint64_t voxel_key(const VoxelIndex& v) {
  constexpr int kOffset = 1 << 20;
  constexpr std::uint64_t kMask = (1U << 21U) - 1U;
  return ((static_cast<std::uint64_t>(v.x() + kOffset) & kMask) << 42U) |
         ((static_cast<std::uint64_t>(v.y() + kOffset) & kMask) << 21U) |
         (static_cast<std::uint64_t>(v.z() + kOffset) & kMask);
}

/// Inverse of voxel_key.
[[nodiscard]] inline VoxelIndex voxel_of_key(std::uint64_t key) {
  constexpr int kOffset = 1 << 20;
  constexpr std::uint64_t kMask = (1U << 21U) - 1U;
  return {static_cast<int>((key >> 42U) & kMask) - kOffset,
          static_cast<int>((key >> 21U) & kMask) - kOffset,
          static_cast<int>(key & kMask) - kOffset};
}

/// Mean of the points (and of every channel; normals renormalised, colours rounded) of each
/// occupied voxel, in ascending voxel order: independent of the order of the input but for
/// rounding. `sources` keep the first point's value. Non-finite points are dropped. @pre voxel_m >
/// 0
[[nodiscard]] PointCloud voxel_mean(const PointCloud& cloud, double voxel_m);

}  // namespace hybridfusion
