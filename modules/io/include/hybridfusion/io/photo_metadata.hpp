#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>

#include <filesystem>

namespace hybridfusion {

/// EXIF and XMP of a JPEG. Values that are missing, unreadable or impossible (position (0, 0),
/// latitude 91, NaN) are empty; metadata damage never fails the photo.
/// @returns kNotFound for a missing file, kParse when the file is not a JPEG.
[[nodiscard]] Expected<PhotoMetadata> read_photo_metadata(const std::filesystem::path& path);

/// Whether the EXIF position is (0, 0), which receivers without a fix write and read_photo_metadata
/// drops. False when the file cannot be read.
[[nodiscard]] bool has_null_position(const std::filesystem::path& photo);

}  // namespace hybridfusion
