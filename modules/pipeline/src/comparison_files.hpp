#pragma once

#include "pair_metrics.hpp"

#include <hybridfusion/pipeline/workspace.hpp>

namespace hybridfusion {

/// Pictures' worth of the registration: `evaluation/cross_section.csv`, two vertical slices of both
/// clouds with L at the coarse pose and at the final one, and `evaluation/difference.ply`, the
/// registered L whose intensity is the distance to the nearest point of G [m], cut at 1 m.
[[nodiscard]] Expected<void> write_comparison(const Workspace& workspace,
                                              const RegisteredPair& pair,
                                              const RunContext& ctx);

}  // namespace hybridfusion
