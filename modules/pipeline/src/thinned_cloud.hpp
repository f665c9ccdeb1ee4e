#pragma once

#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/core/sim3.hpp>

#include <filesystem>

namespace hybridfusion {

/// The first point of each voxel of a PLY cloud with its channels, moved into the target frame. The
/// file is read in batches: memory is that of the result.
/// @returns errors of read_ply; kCancelled.
[[nodiscard]] Expected<PointCloud> read_thinned(const std::filesystem::path& path,
                                                double voxel_m,
                                                const Sim3& target_from_cloud,
                                                const RunContext& ctx);

}  // namespace hybridfusion
