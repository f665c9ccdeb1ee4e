#pragma once

#include "scan_store.hpp"

#include <hybridfusion/lidar/loop_closure_options.hpp>

#include <span>
#include <vector>

namespace hybridfusion {

/// Way driven until each scan [m].
struct DrivenWay {
  std::vector<double> total_m = {};
  std::vector<double> blind_m = {};  ///< The part of it that the LiDAR did not fully measure.
};

/// Scans flagged as degenerate, unmatched, diverged or behind a gap count as blind.
[[nodiscard]] DrivenWay driven_way(std::span<const StoredScan> scans);

/// How far odometry may have drifted between two scans.
struct DriftBound {
  double position_m = 0.0;
  double yaw_rad = 0.0;
};
[[nodiscard]] DriftBound drift_bound(const LoopClosureOptions& options,
                                     std::span<const StoredScan> scans,
                                     const DrivenWay& way,
                                     std::size_t first,
                                     std::size_t second);

/// Two scans that may have been taken near each other; first < second.
struct LoopCandidate {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// Pairs of places that the drive may have passed twice, given how far it may have drifted: the
/// nearest place of each earlier visit, at most two visits, spread evenly to at most
/// `max_candidates`.
[[nodiscard]] std::vector<LoopCandidate> find_loop_candidates(const LoopClosureOptions& options,
                                                              std::span<const StoredScan> scans,
                                                              const DrivenWay& way);

}  // namespace hybridfusion
