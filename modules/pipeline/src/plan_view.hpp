#pragma once

#include <hybridfusion/pipeline/workspace.hpp>

#include <string>

namespace hybridfusion {

/// Map of the flight and the drive seen from above, as inline SVG: camera positions as measured by
/// GNSS and as estimated, and the LiDAR trajectory when it is registered. Drawn from positions.csv,
/// trajectory.tum and registration.json; a sentence when there is nothing to draw.
[[nodiscard]] std::string plan_view_svg(const Workspace& workspace);

}  // namespace hybridfusion
