#pragma once

#include "plane_adjustment.hpp"
#include "scan_store.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/lidar/refinement_options.hpp>

namespace hybridfusion {

struct RefinementReport {
  int iterations = 0;
  std::size_t num_segments = 0;
  std::size_t num_planes = 0;
  double rms_before_m = 0.0;  ///< Of cluster means about their planes, first pass.
  double rms_after_m = 0.0;   ///< Last pass.
};

/// Improves all scan poses in `store` together (see PlaneAdjustment): half of the passes without
/// the limit by the range noise, to bring visits together that are some centimetres apart, then
/// with it. @returns kCancelled, kDegenerate, kIo.
[[nodiscard]] Expected<RefinementReport> refine_poses(const LidarRefineOptions& options,
                                                      const RunContext& ctx,
                                                      ScanStore& store);

}  // namespace hybridfusion
