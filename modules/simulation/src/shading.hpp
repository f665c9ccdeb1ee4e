#pragma once

#include "ray_tracer.hpp"
#include "scene.hpp"

#include <Eigen/Core>

namespace hybridfusion {

/// Linear colour of a surface at a point, averaged over `footprint_m`.
/// @param view  Unit vector from the point to the eye (glass mirrors the sky).
[[nodiscard]] Eigen::Vector3f surface_color(const Surface& surface,
                                            const Eigen::Vector3f& point,
                                            const Eigen::Vector3f& normal,
                                            const Eigen::Vector3f& view,
                                            float footprint_m);

/// Geometric normal of a face, unit length, as wound.
[[nodiscard]] Eigen::Vector3f face_normal(const Scene& scene, std::uint32_t face);

/// Ambient light interpolated at a hit, 0..1.
[[nodiscard]] float ambient_at(const Scene& scene, const RayHit& hit);

/// Factor on the surface's colour at a hit.
[[nodiscard]] Eigen::Vector3f tint_at(const Scene& scene, const RayHit& hit);

/// Radiance of the sky in a direction.
[[nodiscard]] Eigen::Vector3f sky_color(const Eigen::Vector3f& direction);

}  // namespace hybridfusion
