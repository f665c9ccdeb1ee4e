#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>

namespace hybridfusion {

/// Makes one sheet of the points of a surface. Each point moves along the local normal onto the
/// inverse-variance mean of its 24 nearest ones where these are flat; at corners and in leaves it
/// stays. A point that holds few depths beside a sheet whose points hold many is left out, and so
/// is one whose mean distance to its neighbours is far above the average: a speck in the air.
/// Normals come from the same neighbourhood, `sigmas_m` from the point's own and from how far its
/// neighbours leave their plane.
/// @pre `normals` hold the direction to the photos, which the normals will have; `sigmas_m` the
/// deviations that matching leads to; `confidences` the number of depths, or none
[[nodiscard]] PointCloud one_sheet(PointCloud cloud, const RunContext& ctx);

}  // namespace hybridfusion
