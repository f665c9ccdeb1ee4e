#pragma once

#include "loop_candidates.hpp"

#include <optional>

namespace hybridfusion {

/// A place seen twice, measured.
struct Loop {
  LoopCandidate scans = {};
  Rigid3 first_from_second = {};  ///< Between the IMU frames of the two scans.
  double score = 0.0;             ///< 0..1
};

/// Registers the surroundings of the second scan to those of the first: plan search within the
/// drift bound, then alignment of faces. Nothing when they do not fit, when the fit can slide, or
/// when another place within the bound fits about as well. @returns kIo.
[[nodiscard]] Expected<std::optional<Loop>> verify_loop(const LoopClosureOptions& options,
                                                        const ScanStore& store,
                                                        const DrivenWay& way,
                                                        const LoopCandidate& candidate);

/// The loops that agree with each other: two loops near each other on both visits must tell the
/// same but for the drift in between. Loops that fewer than `min_support` others back are left out,
/// and of contradicting groups all but the largest. In the order given.
[[nodiscard]] std::vector<Loop> consistent_loops(const LoopClosureOptions& options,
                                                 std::span<const StoredScan> scans,
                                                 const DrivenWay& way,
                                                 const std::vector<Loop>& loops);

}  // namespace hybridfusion
