#pragma once

#include "scan_store.hpp"

#include <vector>

namespace hybridfusion {

/// A small face of a submap.
struct Surfel {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();    ///< [m]
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< Unit length, either sign.
};

/// What the vehicle saw along a short stretch of its way: coordinates along the axes of the map,
/// from the IMU position at the middle of the stretch [m].
struct Submap {
  std::vector<Surfel> surfels = {};
  std::vector<Eigen::Vector2f> walls = {};   ///< Centres of plan cells with something upright.
  std::vector<Eigen::Vector3f> ground = {};  ///< Lowest point of plan cells.
};

/// Side of the plan cells of Submap::walls [m].
inline constexpr float kPlanCell_m = 0.5F;

/// Submap of the scans [first, last), seen from scan `middle`; points farther than `radius_m` from
/// it are left out. @returns kIo.
[[nodiscard]] Expected<Submap> build_submap(const ScanStore& store,
                                            std::size_t first,
                                            std::size_t last,
                                            std::size_t middle,
                                            float radius_m);

}  // namespace hybridfusion
