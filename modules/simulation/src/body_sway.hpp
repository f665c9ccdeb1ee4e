#pragma once

#include "vehicle_motion.hpp"

#include <cstdint>
#include <vector>

namespace hybridfusion {

inline constexpr double kTimeStep_s = 0.05;  ///< Between the control values of a drive.

/// Leans the body outwards in curves, softly.
/// @param distance  Way driven at each control value [m].
void add_body_roll(const std::vector<double>& distance,
                   double roll_per_g_rad,
                   VehicleMotion::Channels& channels);

/// Swings roll and pitch by up to `amplitude_rad`, each with its own period of 2 to 4 s; fades out
/// where the vehicle stands.
void add_swing(const std::vector<double>& distance,
               double amplitude_rad,
               std::uint64_t seed,
               std::uint64_t index,
               VehicleMotion::Channels& channels);

/// Rolls, pitches (half as far) and heaves as a boat in a swell, from the first moment on, each
/// with its own period of 3 to 6 s.
void add_boat_sway(double amplitude_rad,
                   std::uint64_t seed,
                   std::uint64_t index,
                   VehicleMotion::Channels& channels);

}  // namespace hybridfusion
