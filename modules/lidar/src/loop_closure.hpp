#pragma once

#include "scan_store.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/lidar/loop_closure_options.hpp>

#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

struct LoopClosureReport {
  std::size_t num_candidates = 0;  ///< Pairs of places looked at.
  std::size_t num_loops = 0;       ///< That fit each other, are backed by others and were kept.
  double max_error_m = 0.0;        ///< By which a kept loop was open.
  double max_move_m = 0.0;         ///< Of a scan.
  bool applied = false;            ///< False: the poses are as before.
  std::string contradiction = {};  ///< Why loops were not applied, in a sentence.
};

/// What GNSS knows of the drive.
struct GnssTrack {
  std::span<const GnssFix> fixes = {};
  Eigen::Vector3d antenna_in_imu = Eigen::Vector3d::Zero();  ///< [m]
};

/// Finds places that were passed twice and moves the scan poses so that they agree: a pose graph of
/// segments of `segment_s` with odometry, loops, gravity and, weakly, GNSS. Poses stay as they are,
/// bit for bit, without loops, when the loops are closed already, and when they contradict the
/// odometry. Scans of stretches that changed by more than 3 cm are flagged kLoopCorrected.
/// @returns kCancelled, kIo.
[[nodiscard]] Expected<LoopClosureReport> close_loops(const LoopClosureOptions& options,
                                                      double segment_s,
                                                      const GnssTrack& gnss,
                                                      const RunContext& ctx,
                                                      ScanStore& store);

}  // namespace hybridfusion
