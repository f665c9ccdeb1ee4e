#pragma once

#include <hybridfusion/io/colmap_model.hpp>

namespace hybridfusion {

/// cameras.txt, images.txt and points3D.txt. @returns kNotFound; kParse naming file and line.
[[nodiscard]] Expected<ColmapModel> read_colmap_text(const std::filesystem::path& folder);
/// cameras.bin, images.bin and points3D.bin. @returns kNotFound; kParse naming file and byte.
[[nodiscard]] Expected<ColmapModel> read_colmap_binary(const std::filesystem::path& folder);

}  // namespace hybridfusion
