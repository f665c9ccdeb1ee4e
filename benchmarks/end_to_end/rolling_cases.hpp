#pragma once

#include <hybridfusion/simulation/simulation_options.hpp>

#include <cstdint>
#include <string>

namespace hybridfusion::benchmark {

/// One simulated drive that is rolling when the recording begins.
struct RollingCase {
  int number = 0;
  std::uint64_t seed = 0;  ///< Of the simulation.
  double speed_mps = 0.0;
  std::string text = {};
  std::string fault = {};  ///< Empty: a sound recording.
  SimulationOptions simulation = {};
};

/// Case `number` (from 0): the same for the same seed, whatever others are made. Each fifth has a
/// fault. @pre number >= 0
[[nodiscard]] RollingCase rolling_case(int number, std::uint64_t seed);

}  // namespace hybridfusion::benchmark
