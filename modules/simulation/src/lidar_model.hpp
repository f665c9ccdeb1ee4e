#pragma once

#include "ray_tracer.hpp"
#include "vehicle_motion.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <cstdint>
#include <vector>

namespace hybridfusion {

/// One return, in the LiDAR frame at its own time.
struct LidarReturn {
  Eigen::Vector3f point = Eigen::Vector3f::Zero();  ///< [m]
  float intensity = 0.0F;
  std::int32_t offset_ns = 0;  ///< Since the scan began.
  std::uint16_t ring = 0;      ///< Beam, or laser line of the Avia model.
};

struct LidarSetup {
  LidarModelOptions options = {};
  Rigid3 body_from_lidar = {};
  std::uint64_t seed = 0;
  std::uint64_t drive = 0;
};

/// One scan that begins at `start_s`: every ray leaves from the pose at its own time. Rays are lost
/// on glass, at grazing angles and far away; at edges some returns lie between two surfaces.
[[nodiscard]] std::vector<LidarReturn> scan_scene(const Scene& scene,
                                                  const RayTracer& tracer,
                                                  const VehicleMotion& motion,
                                                  const LidarSetup& setup,
                                                  std::uint64_t scan,
                                                  double start_s);

/// Direction of a point in the LiDAR frame lies in the field of view (for truth/samples.ply).
[[nodiscard]] bool in_field_of_view(const LidarModelOptions& options,
                                    const Eigen::Vector3d& point_in_lidar);

}  // namespace hybridfusion
