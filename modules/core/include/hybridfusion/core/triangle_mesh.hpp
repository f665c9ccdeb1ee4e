#pragma once

#include <hybridfusion/core/point_cloud.hpp>

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

/// Indexed triangles in one local metric frame, e.g. the true surface of a simulated scene.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices = {};                ///< [m]
  std::vector<Rgb8> colors = {};                             ///< One per vertex, or empty.
  std::vector<std::array<std::uint32_t, 3>> triangles = {};  ///< Into `vertices`.
  std::vector<std::uint8_t> labels = {};                     ///< One per triangle, or empty.
};

}  // namespace hybridfusion
