#pragma once

#include "pinhole_camera.hpp"
#include "ray_tracer.hpp"
#include "world.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/geodetic.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// One photo of the flight.
struct Shot {
  std::string name = {};  ///< "IMG_0001.JPG"
  double time_s = 0.0;    ///< Since the take-off.
  Rigid3 world_from_camera = {};
  Eigen::Vector3d gnss_in_enu = Eigen::Vector3d::Zero();  ///< As the drone's receiver says [m].
};

/// Lawn-mower grid looking down, then a ring of oblique photos around every block, in flight order.
/// Wind and the mount move each photo off the plan.
[[nodiscard]] std::vector<Shot> plan_flight(const Terrain& terrain,
                                            const SimulationOptions& options,
                                            std::uint64_t seed);

/// Renders the shots into `folder`. @returns kIo, kCancelled.
[[nodiscard]] Expected<void> fly(const Scene& scene,
                                 const RayTracer& tracer,
                                 const PinholeCamera& camera,
                                 const std::vector<Shot>& shots,
                                 const SimulationOptions& options,
                                 const GeodeticOrigin& origin,
                                 const std::filesystem::path& folder,
                                 const RunContext& ctx);

inline constexpr double kTakeOffTime_s = 1777629600.0;  ///< 2026-05-01 10:00:00 UTC.

}  // namespace hybridfusion
