#pragma once

#include "scan_store.hpp"

#include <optional>
#include <span>

namespace hybridfusion {

struct GravityFit {
  Eigen::Vector3d gravity_in_map = Eigen::Vector3d::Zero();   ///< [m/s^2]
  Eigen::Vector3d accel_bias_mps2 = Eigen::Vector3d::Zero();  ///< In the IMU frame.
  double tilt_sigma_rad = 0.0;  ///< Formal deviation of gravity's direction.
};

/// Gravity and accelerometer bias that best explain the scan poses by what the IMU measured between
/// them; velocities drop out by differences over neighbouring windows. Nothing when there are too
/// few unbridged windows.
[[nodiscard]] std::optional<GravityFit> fit_gravity(std::span<const StoredScan> scans);

/// What the IMU measured between three scans of ascending index.
struct InertialVelocityChange {
  double before_s = 0.0;  ///< From the first to the middle scan.
  double behind_s = 0.0;  ///< From the middle to the last one.
  /// Mean velocity behind the middle scan minus that before it, in the map [m/s].
  Eigen::Vector3d in_map_mps = Eigen::Vector3d::Zero();
};

/// Nothing when part of the motion was not measured.
[[nodiscard]] std::optional<InertialVelocityChange> inertial_velocity_change(
    std::span<const StoredScan> scans,
    std::size_t first,
    std::size_t middle,
    std::size_t last,
    const GravityFit& fit);

struct MapLevel {
  double turn_rad = 0.0;  ///< Angle by which the map was turned.
  double sigma_rad =
      0.0;  ///< Formal deviation of the map's vertical; 0: not known, left as it was.
};

/// Turns the map about its first pose so that gravity points down: by fit_gravity where that is
/// certain enough, else as the filter came to know gravity. Left as it is when no IMU measured it.
MapLevel level_map(std::vector<StoredScan>& scans);
/// Turns the map about its first pose so that `up_in_map` becomes z. @returns the angle [rad].
double turn_upright(const Eigen::Vector3d& up_in_map, std::vector<StoredScan>& scans);

}  // namespace hybridfusion
