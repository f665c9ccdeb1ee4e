#pragma once

#include "position_conflicts.hpp"

#include <vector>

namespace hybridfusion {

/// Ground control against the positions of the photos that show it: farther than any of them can
/// see, or above all of them.
[[nodiscard]] std::vector<PositionConflict> compare_control(const PositionSources& sources,
                                                            const PositionLimits& limits);

}  // namespace hybridfusion
