#pragma once

#include <Eigen/Core>

namespace hybridfusion {

/// Farthest from the origin, on every axis, that voxel_key() tells voxels apart [m]: beyond it keys
/// wrap, and a cell comes back on the other side.
[[nodiscard]] inline double voxel_key_reach_m(double voxel_m) {
  constexpr int kMaxIndex = (1 << 20) - 1;
  return kMaxIndex * voxel_m;
}

[[nodiscard]] inline bool in_voxel_key_reach(const Eigen::Vector3d& point, double voxel_m) {
  return point.cwiseAbs().maxCoeff() < voxel_key_reach_m(voxel_m);  // false for NaN
}

}  // namespace hybridfusion
