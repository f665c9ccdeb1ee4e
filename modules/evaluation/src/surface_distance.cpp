#include <hybridfusion/evaluation/surface_distance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::uint32_t kLeafSize = 4;

struct Triangle {
  Eigen::Vector3f a, b, c;
  std::uint32_t index;
};

/// Children of an inner node are `first` and `first + 1`; a leaf holds `count` triangles.
struct Node {
  Eigen::AlignedBox3f box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;  // 0: inner node
};

Eigen::AlignedBox3f box_of(const Triangle& triangle) {
  Eigen::AlignedBox3f box(triangle.a);
  box.extend(triangle.b);
  box.extend(triangle.c);
  return box;
}

float box_distance_m2(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& p) {
  const Eigen::Array3f outside = (box.min() - p).array().max((p - box.max()).array()).max(0.0F);
  return outside.matrix().squaredNorm();
}

/// Splits at the median of the longest axis of the centroids: depth <= log2(n / 4) + 1.
void split(std::vector<Node>& nodes,
           std::vector<Triangle>& triangles,
           std::uint32_t node,
           std::uint32_t begin,
           std::uint32_t end) {
  Eigen::AlignedBox3f box;
  Eigen::AlignedBox3f centroids;
  for (std::uint32_t i = begin; i < end; ++i) {
    box.extend(box_of(triangles[i]));
    centroids.extend(box_of(triangles[i]).center());
  }
  nodes[node].box = box;
  if (end - begin <= kLeafSize) {
    nodes[node].first = begin;
    nodes[node].count = end - begin;
    return;
  }
  Eigen::Index axis = 0;
  centroids.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return triangles.begin() + i; };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Triangle& l, const Triangle& r) {
    const float left = box_of(l).center()[axis];
    const float right = box_of(r).center()[axis];
    return left != right ? left < right : l.index < r.index;
  });
  const auto children = static_cast<std::uint32_t>(nodes.size());
  nodes[node].first = children;
  nodes.resize(nodes.size() + 2);
  split(nodes, triangles, children, begin, middle);
  split(nodes, triangles, children + 1, middle, end);
}

float segment_distance_m2(const Eigen::Vector3f& p,
                          const Eigen::Vector3f& a,
                          const Eigen::Vector3f& b) {
  const Eigen::Vector3f ab = b - a;
  const float length2 = ab.squaredNorm();
  const float t = length2 > 0.0F ? std::clamp((p - a).dot(ab) / length2, 0.0F, 1.0F) : 0.0F;
  return (p - a - t * ab).squaredNorm();
}

}  // namespace

float squared_distance_m2(const Eigen::Vector3f& point,
                          const Eigen::Vector3f& a,
                          const Eigen::Vector3f& b,
                          const Eigen::Vector3f& c) {
  const Eigen::Vector3f ab = b - a;
  const Eigen::Vector3f ac = c - a;
  const Eigen::Vector3f ap = point - a;
  const float d00 = ab.squaredNorm();
  const float d01 = ab.dot(ac);
  const float d11 = ac.squaredNorm();
  const float d20 = ap.dot(ab);
  const float d21 = ap.dot(ac);
  const float determinant = d00 * d11 - d01 * d01;  // 4 * area^2
  // Below this the triangle is a sliver whose plane float cannot tell; its edges say all.
  if (determinant > 1e-6F * d00 * d11) {
    const float v = (d11 * d20 - d01 * d21) / determinant;
    const float w = (d00 * d21 - d01 * d20) / determinant;
    if (v >= 0.0F && w >= 0.0F && v + w <= 1.0F) {
      const float height = ap.dot(ab.cross(ac).normalized());
      return height * height;
    }
  }
  return std::min({segment_distance_m2(point, a, b),
                   segment_distance_m2(point, b, c),
                   segment_distance_m2(point, c, a)});
}

struct SurfaceDistance::Impl {
  std::vector<Triangle> triangles;
  std::vector<Node> nodes;
};

SurfaceDistance::SurfaceDistance(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
SurfaceDistance::~SurfaceDistance() = default;
SurfaceDistance::SurfaceDistance(SurfaceDistance&&) noexcept = default;
SurfaceDistance& SurfaceDistance::operator=(SurfaceDistance&&) noexcept = default;

Expected<SurfaceDistance> SurfaceDistance::build(
    std::span<const Eigen::Vector3f> vertices,
    std::span<const std::array<std::uint32_t, 3>> triangles) {
  if (triangles.empty()) return fail(ErrorCode::kInsufficient, "the mesh has no triangle");
  auto impl = std::make_unique<Impl>();
  impl->triangles.reserve(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t corner : triangles[i]) {
      if (corner >= vertices.size() || !vertices[corner].allFinite()) {
        return fail(ErrorCode::kParse,
                    fmt::format("triangle {} uses vertex {} of {}, which does not exist or is not "
                                "finite",
                                i,
                                corner,
                                vertices.size()));
      }
    }
    impl->triangles.push_back(
        {vertices[triangles[i][0]], vertices[triangles[i][1]], vertices[triangles[i][2]], i});
  }
  impl->nodes.reserve(triangles.size());
  impl->nodes.resize(1);
  split(impl->nodes, impl->triangles, 0, 0, static_cast<std::uint32_t>(triangles.size()));
  return SurfaceDistance(std::move(impl));
}

SurfacePoint SurfaceDistance::nearest(const Eigen::Vector3f& query) const {
  struct Pending {
    std::uint32_t node;
    float distance_m2;
  };
  std::array<Pending, 64> stack;  // one entry a level; 2^32 triangles make 31 levels
  std::size_t depth = 0;
  float best_m2 = std::numeric_limits<float>::infinity();
  std::uint32_t triangle = 0;
  stack[depth++] = {0, 0.0F};
  while (depth > 0) {
    const Pending pending = stack[--depth];
    if (pending.distance_m2 >= best_m2) continue;
    const Node& node = impl_->nodes[pending.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Triangle& t = impl_->triangles[i];
      const float distance_m2 = squared_distance_m2(query, t.a, t.b, t.c);
      if (distance_m2 < best_m2) {
        best_m2 = distance_m2;
        triangle = t.index;
      }
    }
    if (node.count > 0) continue;
    Pending near{node.first, box_distance_m2(impl_->nodes[node.first].box, query)};
    Pending far{node.first + 1, box_distance_m2(impl_->nodes[node.first + 1].box, query)};
    if (far.distance_m2 < near.distance_m2) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return {.distance_m = std::sqrt(best_m2), .triangle = triangle};
}

}  // namespace hybridfusion
