#pragma once

#include "dense_box_scene.hpp"

#include <vector>

namespace hybridfusion::testing {

inline constexpr double kRoof_m = 4.0;

/// Ground z = 0 and a box of 6 x 6 m with a flat roof.
inline BoxScene block() {
  return {.box_half_m = 3.0, .box_height_m = kRoof_m, .texture_m = 0.8};
}

/// Where a ray in ENU meets the ground without the box. @pre it does
inline Eigen::Vector3d hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) {
  return origin - origin.z() / ray.z() * ray;
}

/// Photo of the ground without the box: no window mixes two surfaces.
inline Image8 render(const CameraIntrinsics& camera, const Rigid3& enu_from_camera) {
  BoxScene ground = block();
  ground.box_height_m = 0.0;
  return photograph(ground, {camera, enu_from_camera});
}

using DenseScene = Survey;

/// Four photos from 40 m at the corners of a square of 8 m.
inline DenseScene make_dense_scene() {
  static const DenseScene kScene = [] {
    const CameraIntrinsics camera{.width_px = 320,
                                  .height_px = 240,
                                  .focal_px = 400.0,
                                  .principal_point_px = {159.5, 119.5},
                                  .k1 = -0.04};
    const Eigen::Vector3d down(0.0, 0.0, -1.0);
    return survey(block(),
                  {looking({-4, -4, 40}, down, 0.0),
                   looking({4, -4, 40}, down, 0.0),
                   looking({4, 4, 40}, down, 0.0),
                   looking({-4, 4, 40}, down, 0.0)},
                  camera);
  }();
  return kScene;
}

}  // namespace hybridfusion::testing
