#pragma once

#include <hybridfusion/lidar/odometry_options.hpp>
#include <hybridfusion/simulation/simulation_options.hpp>

#include <span>
#include <string>
#include <vector>

namespace hybridfusion::benchmark {

/// What a run should reach; 0 where nothing is asked.
struct Goals {
  double filter_ate_m = 0.0;
  double offline_ate_m = 0.0;
  double startup_m = 0.0;  ///< Largest error of the first 8 s.
};

/// FAST_LIO on a drive of the same kind (not the same world): for orientation.
struct Reference {
  double ate_m = 0.0;
  double cpu_ms_median = 0.0;
  double cpu_ms_p95 = 0.0;
  double memory_mib = 0.0;
};

/// A kind of drive: how it is simulated and what is asked of it.
struct DriveKind {
  std::string name = {};
  std::string text = {};
  bool unasked = true;  ///< Part of the table that is printed without --only.
  Goals goals = {};
  Reference fast_lio = {};
  SimulationOptions simulation = {};
};

[[nodiscard]] const std::vector<DriveKind>& drive_kinds();

/// How the recording is worked on: "hash", "ikdtree", ... for the filter alone with that local map,
/// "offline" for the whole of module B with the default one.
struct Variant {
  std::string name = {};
  OdometryOptions options = {};
  bool offline = false;
};

/// Every local map that the options know, then the offline pass.
[[nodiscard]] std::vector<Variant> variants();

}  // namespace hybridfusion::benchmark
