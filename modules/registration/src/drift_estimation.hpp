#pragma once

#include "fine_samples.hpp"

#include <hybridfusion/core/sim3.hpp>
#include <hybridfusion/registration/drift.hpp>

#include <span>

namespace hybridfusion {

/// Drift of L about a pose, and the motion that takes its rigid part into the pose.
struct DriftEstimate {
  DriftCorrection correction = {};  ///< In the frame of the samples, without its rigid part.
  Rigid3 rigid = {};                ///< The pose with drift known is the given one times this.
};

/// Bends L along the drive onto the planes of G, point to plane: a shift and a turn about z at
/// every knot, linear between knots. Every fourth piece of the drive is held out and judges the
/// result. What a correction cannot tell from a bend of G stays below DriftOptions::min_size_m.
/// @param at  Where each sample lies on `axis`.
/// @param length_m  Of the drive, for the distance of the knots.
/// @returns kInsufficient when too few samples meet a plane, kCancelled when stopped.
[[nodiscard]] Expected<DriftEstimate> estimate_drift(FineInputs& inputs,
                                                     const Sim3& vision_from_lidar,
                                                     std::span<const double> at,
                                                     DriftAxis axis,
                                                     double length_m,
                                                     const FineOptions& fine,
                                                     const DriftOptions& options,
                                                     const RunContext& ctx);

}  // namespace hybridfusion
