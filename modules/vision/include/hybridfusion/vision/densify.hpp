#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <filesystem>
#include <span>

namespace hybridfusion {

/// Dense cloud G from posed photos (HybridFusion III-A.2): rectified stereo pairs, semi-global
/// matching, depth and photometric consistency, fusion by inverse variance.
///
/// @param photos  One per view of `reconstruction`, in the same order; only registered ones are
///                decoded, one at a time and thread.
/// @param scratch_folder  Where photos' depths lie that exceed `max_memory_mib`, in a file without
/// a
///                name; empty: all stay in memory. The result is the same.
/// @returns       Points in the ENU frame of `reconstruction` with normals (towards the photos),
///                colours, `sigmas_m` (from matching and from the scatter of the neighbours) and
///                `confidences` (number of depths that were merged), in ascending voxel order.
///                kInsufficient when fewer than two photos are registered or no pair can be
///                matched; kIo for the scratch folder; kCancelled.
[[nodiscard]] Expected<PointCloud> densify(std::span<const Photo> photos,
                                           const Reconstruction& reconstruction,
                                           const DensifyOptions& options,
                                           const RunContext& ctx = {},
                                           const std::filesystem::path& scratch_folder = {});

}  // namespace hybridfusion
