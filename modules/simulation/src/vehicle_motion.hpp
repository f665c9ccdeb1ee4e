#pragma once

#include "drive_path.hpp"
#include "terrain.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace hybridfusion {

/// State of the vehicle's body at one moment; all derivatives are exact derivatives of the pose.
struct MotionState {
  Rigid3 world_from_body = {};
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();            ///< In the world.
  Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero();       ///< In the world.
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  ///< In the body.
};

/// Smooth motion: uniform cubic B-splines (C2) of x, y, z, yaw, pitch, roll over time.
class VehicleMotion {
 public:
  using Channels = std::array<std::vector<double>, 6>;  ///< x y z [m], yaw pitch roll [rad].

  /// @param controls  Control values `step_s` apart, the first one step before time 0.
  VehicleMotion(Channels controls, double step_s);

  [[nodiscard]] double duration_s() const;
  /// @param time_s  Since the start; clamped to the duration.
  [[nodiscard]] MotionState at(double time_s) const;

 private:
  Channels controls_;
  double step_s_;
};

/// Drives the plan: standstill, smooth speed limited by curvature, bumps, body roll, slope.
/// The body is 0.95 m above the road. @returns kInvalidOptions when the recording is too short.
[[nodiscard]] Expected<VehicleMotion> drive(const DrivePlan& plan,
                                            const Terrain& terrain,
                                            const DriveOptions& options,
                                            std::uint64_t seed,
                                            std::uint64_t index);

}  // namespace hybridfusion
