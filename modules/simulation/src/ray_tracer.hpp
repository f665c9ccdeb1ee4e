#pragma once

#include "scene.hpp"

#include <array>
#include <cstdint>
#include <memory>

#include <Eigen/Core>

namespace hybridfusion {

inline constexpr std::uint32_t kNoFace = 0xffffffffU;

struct RayHit {
  std::uint32_t face = kNoFace;
  float distance_m = 0.0F;
  float u = 0.0F;  ///< Barycentric weights of the face's second and third vertex.
  float v = 0.0F;
};

/// Nearest hits on the triangles of a scene (Embree). Thread-safe.
class RayTracer {
 public:
  explicit RayTracer(const Scene& scene);
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;
  ~RayTracer();

  /// @param direction  Unit length.
  [[nodiscard]] RayHit cast(const Eigen::Vector3f& origin,
                            const Eigen::Vector3f& direction,
                            float near_m,
                            float far_m) const;
  [[nodiscard]] bool blocked(const Eigen::Vector3f& origin,
                             const Eigen::Vector3f& direction,
                             float near_m,
                             float far_m) const;
  /// Four rays at once from one origin; lanes at and beyond `count` are not traced.
  [[nodiscard]] std::array<RayHit, 4> cast4(const Eigen::Vector3f& origin,
                                            const std::array<Eigen::Vector3f, 4>& directions,
                                            int count) const;
  /// Bit i is set when ray i is blocked; only rays whose bit is set in `wanted` are traced.
  [[nodiscard]] unsigned blocked4(const std::array<Eigen::Vector3f, 4>& origins,
                                  const std::array<Eigen::Vector3f, 4>& directions,
                                  unsigned wanted) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion
