#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/pipeline/workspace.hpp>
#include <hybridfusion/vision/photo_cache.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <filesystem>
#include <string>

namespace hybridfusion {

/// PhotoCache::keys entry of a photo file: its content with everything else that its features and
/// matches depend on. @param photo_sha256  Of the file.
[[nodiscard]] std::string photo_cache_key(const std::string& photo_sha256,
                                          const ReconstructionOptions& options);

/// A cache of files below vision/ of the workspace, without keys. A folder that cannot be made or a
/// full disk costs a warning: nothing is kept then.
[[nodiscard]] PhotoCache open_photo_cache(const Workspace& workspace, const RunContext& ctx);

/// Deletes it: its photos are reconstructed.
void remove_photo_cache(const Workspace& workspace);

}  // namespace hybridfusion
