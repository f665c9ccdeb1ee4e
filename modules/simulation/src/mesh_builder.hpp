#pragma once

#include "scene.hpp"

#include <span>

#include <Eigen/Geometry>

namespace hybridfusion {

/// A frame on the ground: origin and heading, z up.
struct GroundFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return origin + Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * point;
  }
  [[nodiscard]] GroundFrame at(const Eigen::Vector3d& point, double turn_rad = 0.0) const {
    return {.origin = *this * point, .yaw_rad = yaw_rad + turn_rad};
  }
};

/// Adds geometry to a scene. Big faces are cut so that the ambient light can vary over them.
class MeshBuilder {
 public:
  explicit MeshBuilder(Scene& scene, double max_edge_m) : scene_(scene), max_edge_m_(max_edge_m) {}

  /// Registers a surface whose texture frame is `frame`.
  std::uint32_t add_surface(Surface surface, const GroundFrame& frame);
  /// A planar (or slightly bent) quad p00 p10 p11 p01, counter-clockwise seen from outside.
  void quad(const Eigen::Vector3d& p00,
            const Eigen::Vector3d& p10,
            const Eigen::Vector3d& p11,
            const Eigen::Vector3d& p01,
            std::uint32_t surface);
  void triangle(const Eigen::Vector3d& a,
                const Eigen::Vector3d& b,
                const Eigen::Vector3d& c,
                std::uint32_t surface);
  /// Axis-parallel box in `frame`; the faces are left out whose bit is set: 1 -x, 2 +x, 4 -y, 8 +y,
  /// 16 -z, 32 +z.
  void box(const GroundFrame& frame,
           const Eigen::Vector3d& low,
           const Eigen::Vector3d& high,
           std::uint32_t surface,
           unsigned without = 0);
  /// Prism or cone stub between two circles on the line from `bottom` to `top`; open below.
  void tube(const Eigen::Vector3d& bottom,
            const Eigen::Vector3d& top,
            double radius_bottom_m,
            double radius_top_m,
            int sides,
            std::uint32_t surface);

  [[nodiscard]] Scene& scene() { return scene_; }

 private:
  Scene& scene_;
  double max_edge_m_;
};

}  // namespace hybridfusion
