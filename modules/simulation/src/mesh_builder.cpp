#include "mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hybridfusion {

std::uint32_t MeshBuilder::add_surface(Surface surface, const GroundFrame& frame) {
  surface.local_from_world =
      Eigen::AngleAxisd(-frame.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix().cast<float>();
  surface.origin = frame.origin.cast<float>();
  scene_.surfaces.push_back(surface);
  return static_cast<std::uint32_t>(scene_.surfaces.size() - 1);
}

void MeshBuilder::triangle(const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c,
                           std::uint32_t surface) {
  const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
  for (const auto* point : {&a, &b, &c}) scene_.vertices.push_back(point->cast<float>());
  scene_.faces.push_back({first, first + 1, first + 2});
  scene_.face_surface.push_back(surface);
}

void MeshBuilder::quad(const Eigen::Vector3d& p00,
                       const Eigen::Vector3d& p10,
                       const Eigen::Vector3d& p11,
                       const Eigen::Vector3d& p01,
                       std::uint32_t surface) {
  const double length_u = std::max((p10 - p00).norm(), (p11 - p01).norm());
  const double length_v = std::max((p01 - p00).norm(), (p11 - p10).norm());
  const auto parts = [this](double length) {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / max_edge_m_ - 1e-6)));
  };
  const std::uint32_t nu = parts(length_u);
  const std::uint32_t nv = parts(length_v);
  const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
  for (std::uint32_t j = 0; j <= nv; ++j) {
    for (std::uint32_t i = 0; i <= nu; ++i) {
      const double u = static_cast<double>(i) / nu;
      const double v = static_cast<double>(j) / nv;
      const Eigen::Vector3d point =
          (1 - v) * ((1 - u) * p00 + u * p10) + v * ((1 - u) * p01 + u * p11);
      scene_.vertices.push_back(point.cast<float>());
    }
  }
  for (std::uint32_t j = 0; j < nv; ++j) {
    for (std::uint32_t i = 0; i < nu; ++i) {
      const std::uint32_t a = first + j * (nu + 1) + i;
      const std::uint32_t c = a + nu + 1;
      scene_.faces.push_back({a, a + 1, c + 1});
      scene_.faces.push_back({a, c + 1, c});
      scene_.face_surface.insert(scene_.face_surface.end(), 2, surface);
    }
  }
}

void MeshBuilder::box(const GroundFrame& frame,
                      const Eigen::Vector3d& low,
                      const Eigen::Vector3d& high,
                      std::uint32_t surface,
                      unsigned without) {
  const auto corner = [&](int x, int y, int z) -> Eigen::Vector3d {
    return frame *
           Eigen::Vector3d(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  const auto face = [&](unsigned bit, std::array<int, 12> c) {
    if ((without & bit) != 0) return;
    quad(corner(c[0], c[1], c[2]),
         corner(c[3], c[4], c[5]),
         corner(c[6], c[7], c[8]),
         corner(c[9], c[10], c[11]),
         surface);
  };
  face(1, {0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 1});
  face(2, {1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1});
  face(4, {0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1});
  face(8, {1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 1});
  face(16, {0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0});
  face(32, {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1});
}

void MeshBuilder::tube(const Eigen::Vector3d& bottom,
                       const Eigen::Vector3d& top,
                       double radius_bottom_m,
                       double radius_top_m,
                       int sides,
                       std::uint32_t surface) {
  const Eigen::Vector3d axis = (top - bottom).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  const auto ring = [&](const Eigen::Vector3d& center, double radius, int side) -> Eigen::Vector3d {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    return center + radius * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int side = 0; side < sides; ++side) {
    quad(ring(bottom, radius_bottom_m, side),
         ring(bottom, radius_bottom_m, side + 1),
         ring(top, radius_top_m, side + 1),
         ring(top, radius_top_m, side),
         surface);
    if (radius_top_m > 1e-6) {
      triangle(ring(top, radius_top_m, side), ring(top, radius_top_m, side + 1), top, surface);
    }
  }
}

}  // namespace hybridfusion
