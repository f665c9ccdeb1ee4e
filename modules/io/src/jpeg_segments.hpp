#pragma once

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hybridfusion {

/// What stands in a JPEG file before its pixel data.
struct JpegSegments {
  int width = 0;  ///< [px] of the frame header.
  int height = 0;
  std::vector<std::byte> exif = {};  ///< TIFF structure of the Exif segment; empty without one.
  std::string xmp = {};              ///< XMP packet; empty without one.
  std::uint64_t scan_begin = 0;      ///< Byte offset of the first scan.
};

/// Walks the segments up to the first scan.
/// @returns kNotFound, or kParse naming file and cause when it is not a JPEG or ends before its
/// pixels.
[[nodiscard]] Expected<JpegSegments> read_jpeg_segments(const std::filesystem::path& path);

/// True when an end-of-image marker stands in the last 64 KiB (some cameras append data): the cheap
/// test against truncation.
[[nodiscard]] Expected<bool> has_end_marker(const std::filesystem::path& path,
                                            std::uint64_t scan_begin);

}  // namespace hybridfusion
