#pragma once

#include "pinhole_camera.hpp"
#include "ray_tracer.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>

namespace hybridfusion {

struct RenderSettings {
  int samples_per_pixel = 4;
  double vignetting = 0.2;
  double noise_sd = 1.6;    ///< 8-bit grey levels at mid grey.
  std::uint64_t seed = 0;   ///< Of the sensor noise and the sample positions.
  std::uint64_t index = 0;  ///< Photo number: its own noise.
};

/// Photo of the scene: direct sun with soft shadows, baked ambient light, sky, vignetting, noise.
/// @returns kCancelled.
[[nodiscard]] Expected<Image8> render_photo(const Scene& scene,
                                            const RayTracer& tracer,
                                            const PinholeCamera& camera,
                                            const Rigid3& world_from_camera,
                                            const RenderSettings& settings,
                                            const RunContext& ctx);

}  // namespace hybridfusion
