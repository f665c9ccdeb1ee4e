#pragma once

#include "dense/depth_consistency.hpp"
#include "dense/depth_fusion.hpp"
#include "dense/depth_map.hpp"

#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/vision/camera.hpp>
#include <hybridfusion/vision/reconstruction.hpp>
#include <hybridfusion/vision/rectification.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace hybridfusion::testing {

/// Uncorrelated number in [0, 1) for a lattice point.
inline double lattice(int x, int y, int z) {
  auto h = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
           static_cast<std::uint32_t>(y) * 0xd8163841U ^
           static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
  h ^= h >> 15U;
  h *= 0x2c1b3c6dU;
  h ^= h >> 12U;
  h *= 0x297a2d39U;
  h ^= h >> 15U;
  return static_cast<double>(h) / 4294967296.0;
}

/// Smooth random texture in [30, 225], features of about `size` and twice that.
inline double texture(double u, double v, int layer, double size) {
  const auto octave = [&](double a, double b, int seed) {
    const int x = static_cast<int>(std::floor(a));
    const int y = static_cast<int>(std::floor(b));
    const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double s = ease(a - x);
    const double t = ease(b - y);
    return (1 - t) * ((1 - s) * lattice(x, y, seed) + s * lattice(x + 1, y, seed)) +
           t * ((1 - s) * lattice(x, y + 1, seed) + s * lattice(x + 1, y + 1, seed));
  };
  const double value = 0.6 * octave(u / size, v / size, 2 * layer) +
                       0.4 * octave(0.5 * u / size, 0.5 * v / size, 2 * layer + 1);
  return 30.0 + 195.0 * value;
}

/// Ground z = 0 with one flat-roofed box; beyond `ground_half_m` there is blank sky.
struct BoxScene {
  double ground_half_m = 60.0;
  double box_half_m = 5.0;
  double box_height_m = 6.0;
  double texture_m = 0.5;

  struct Hit {
    double distance = 0.0;  ///< In units of the ray; 0: sky.
    double grey = 200.0;
  };
  [[nodiscard]] Hit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) const {
    Hit hit;
    const auto offer = [&](double t, double u, double v, int layer) {
      if (t > 0.0 && (hit.distance == 0.0 || t < hit.distance)) {
        hit = {.distance = t, .grey = texture(u, v, layer, texture_m)};
      }
    };
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        if (axis == 2 && side < 0.0) continue;
        const double plane = axis == 2 ? box_height_m : side * box_half_m;
        const double t = (plane - origin[axis]) / ray[axis];
        const Eigen::Vector3d p = origin + t * ray;
        const bool inside = (axis == 0 || std::abs(p.x()) <= box_half_m) &&
                            (axis == 1 || std::abs(p.y()) <= box_half_m) &&
                            (axis == 2 || (p.z() >= 0.0 && p.z() <= box_height_m));
        if (inside) offer(t, p[(axis + 1) % 3], p[(axis + 2) % 3], 10 + axis);
      }
    }
    const double t = -origin.z() / ray.z();
    const Eigen::Vector3d p = origin + t * ray;
    if (std::abs(p.x()) < ground_half_m && std::abs(p.y()) < ground_half_m) {
      offer(t, p.x(), p.y(), 1);
    }
    return hit;
  }
};

/// A camera at `centre` that looks along `axis`, its columns turned by `roll_rad` about it.
inline Rigid3 looking(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis, double roll_rad) {
  const Eigen::Vector3d z = axis.normalized();
  const Eigen::Vector3d x =
      (std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY()).eval();
  Eigen::Matrix3d rotation;
  rotation.col(2) = z;
  rotation.col(0) = (x - z * z.dot(x)).normalized();
  rotation.col(1) = z.cross(rotation.col(0));
  return {.rotation =
              Eigen::Quaterniond(rotation) * Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()),
          .translation = centre};
}

inline CameraIntrinsics small_camera(int width_px = 320, int height_px = 240) {
  return {.width_px = width_px,
          .height_px = height_px,
          .focal_px = 0.85 * width_px,
          .principal_point_px = {0.5 * width_px - 2.3, 0.5 * height_px + 1.7},
          .k1 = -0.05,
          .k2 = 0.01,
          .p1 = 0.001,
          .p2 = -0.0005};
}

/// The photo that the camera takes, four rays a pixel.
inline Image8 photograph(const BoxScene& scene, const PosedCamera& camera) {
  const CameraIntrinsics& c = camera.intrinsics;
  Image8 image{.width = c.width_px, .height = c.height_px, .channels = 3};
  for (int y = 0; y < c.height_px; ++y) {
    for (int x = 0; x < c.width_px; ++x) {
      double sum = 0.0;
      for (const double dy : {-0.25, 0.25}) {
        for (const double dx : {-0.25, 0.25}) {
          const Eigen::Vector3d ray = camera.enu_from_camera.rotation *
                                      Eigen::Vector3d(unproject(c, {x + dx, y + dy}).homogeneous());
          sum += scene.cast(camera.enu_from_camera.translation, ray).grey / 4.0;
        }
      }
      image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(std::lround(sum)));
    }
  }
  return image;
}

struct Survey {
  std::vector<Photo> photos;
  Reconstruction reconstruction;
};

/// Photos of the scene with exact poses and exact sparse points on the surface.
inline Survey survey(const BoxScene& scene,
                     const std::vector<Rigid3>& enu_from_camera,
                     const CameraIntrinsics& intrinsics) {
  Survey result;
  Reconstruction& r = result.reconstruction;
  r.cameras = {intrinsics};
  for (std::size_t v = 0; v < enu_from_camera.size(); ++v) {
    const Image8 image = photograph(scene, {intrinsics, enu_from_camera[v]});
    Photo photo;
    photo.load = [image]() -> Expected<Image8> { return image; };
    result.photos.push_back(std::move(photo));
    r.views.push_back({.name = std::to_string(v), .enu_from_camera = enu_from_camera[v]});
  }
  for (int i = -12; i <= 12; ++i) {
    for (int k = -12; k <= 12; ++k) {
      const Eigen::Vector3d above(1.3 * i, 1.3 * k, 100.0);
      const double depth = scene.cast(above, -Eigen::Vector3d::UnitZ()).distance;
      ScenePoint point{.point_in_enu = above - depth * Eigen::Vector3d::UnitZ()};
      const auto index = static_cast<std::uint32_t>(r.points.size());
      for (std::uint32_t v = 0; v < r.views.size(); ++v) {
        const Eigen::Vector3d p = enu_from_camera[v].inverse() * point.point_in_enu;
        const Eigen::Vector3d ray = point.point_in_enu - enu_from_camera[v].translation;
        if (p.z() <= 0.0) continue;
        if (scene.cast(enu_from_camera[v].translation, ray).distance < 0.999) continue;
        const Eigen::Vector2d pixel = project(intrinsics, p);
        if ((pixel.array() < 0.0).any() || pixel.x() > intrinsics.width_px - 1 ||
            pixel.y() > intrinsics.height_px - 1) {
          continue;
        }
        point.track.push_back({v, static_cast<std::uint32_t>(r.views[v].observations.size())});
        r.views[v].observations.push_back({index, pixel.cast<float>()});
      }
      r.points.push_back(point);
    }
  }
  return result;
}

inline PointCloud fused(std::span<const DepthMap> maps, double voxel_m, int min_depths) {
  DepthFusion fusion(voxel_m);
  for (const DepthMap& map : maps) fusion.add(map);
  return fusion.finish(min_depths, {});
}

/// Checks one of the maps against all others.
inline CheckedDepth checked(std::span<const DepthMap> maps,
                            std::uint32_t view,
                            const DepthCheckOptions& options = {},
                            const RunContext& ctx = {}) {
  std::vector<const DepthMap*> others;
  for (const DepthMap& map : maps) {
    if (map.view != view) others.push_back(&map);
  }
  return check_depths(maps[view], others, options, ctx);
}

/// What stereo would hand over for a photo if it made no error.
inline DepthMap perfect_depths(const BoxScene& scene,
                               const PosedCamera& camera,
                               std::uint32_t view,
                               double sigma_m) {
  const CameraIntrinsics& c = camera.intrinsics;
  DepthMap map;
  map.view = view;
  map.grid = {c.width_px, c.height_px, c.focal_px, c.principal_point_px};
  map.enu_from_camera = camera.enu_from_camera;
  map.depth_m = {c.width_px, c.height_px, std::numeric_limits<float>::quiet_NaN()};
  map.sigma_m = {c.width_px, c.height_px, static_cast<float>(sigma_m)};
  map.rgb = {c.width_px, c.height_px};
  map.num_pairs = {c.width_px, c.height_px, 1};
  map.mask = {c.width_px, c.height_px, 255};
  for (int y = 0; y < c.height_px; ++y) {
    for (int x = 0; x < c.width_px; ++x) {
      const Eigen::Vector3d ray = camera.enu_from_camera.rotation * ray_of(map.grid, {x, y});
      const BoxScene::Hit hit = scene.cast(camera.enu_from_camera.translation, ray);
      if (hit.distance > 0.0) map.depth_m.at(x, y) = static_cast<float>(hit.distance);
      const auto grey = static_cast<std::uint8_t>(std::lround(hit.grey));
      map.rgb.at(x, y) = {grey, grey, grey};
    }
  }
  map.grey = grey_plane(map.rgb);
  return map;
}

}  // namespace hybridfusion::testing
