#pragma once

#include "depth_map.hpp"

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/vision/densify_options.hpp>
#include <hybridfusion/vision/reconstruction.hpp>

#include <filesystem>
#include <functional>
#include <span>

namespace hybridfusion {

/// Depths of the registered photos by stereo, checked against one another.
/// @param visit    Is given each photo's map after the check, in the order of the views. Depths
///                 beyond `max_gsd_ratio` times the median depth of the maps are left out.
/// @param scratch  Folder for what exceeds `max_memory_mib`; empty: all in memory.
/// @returns        As densify().
[[nodiscard]] Expected<void> checked_depths(std::span<const Photo> photos,
                                            const Reconstruction& reconstruction,
                                            const DensifyOptions& options,
                                            const RunContext& ctx,
                                            const std::filesystem::path& scratch,
                                            const std::function<void(const DepthMap&)>& visit);

}  // namespace hybridfusion
