#pragma once

#include "vehicle_motion.hpp"

#include <hybridfusion/core/sensor_data.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

namespace hybridfusion {

/// What a faulty IMU delivers for a sound sample. @param state  True motion of the IMU.
[[nodiscard]] ImuSample with_faults(ImuSample sample,
                                    const MotionState& state,
                                    const FaultOptions& faults);

/// What a second IMU delivers that is mounted a quarter turn about z off the first.
[[nodiscard]] ImuSample turned_about_z(ImuSample sample);

}  // namespace hybridfusion
