#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>

#include <filesystem>
#include <string>

namespace hybridfusion {

struct ImageSize {
  int width = 0;  ///< [px]
  int height = 0;
};

/// Decodes a JPEG to RGB (greyscale is replicated; the EXIF orientation is not applied).
/// @returns kNotFound; kParse naming the file for anything that is not an undamaged JPEG
/// ("truncated or damaged"), has CMYK colours, or more than 40000 px a side or 400 million pixels.
[[nodiscard]] Expected<Image8> decode_jpeg(const std::filesystem::path& path);

/// Size from the frame header; errors as decode_jpeg.
[[nodiscard]] Expected<ImageSize> read_jpeg_size(const std::filesystem::path& path);

/// JPEG bytes of an RGB or greyscale image, 4:4:4. @param quality  1..100.
[[nodiscard]] Expected<std::string> encode_jpeg(const Image8& image, int quality);

/// Writes RGB or greyscale, 4:4:4. @param quality  1..100.
[[nodiscard]] Expected<void> write_jpeg(const std::filesystem::path& path,
                                        const Image8& image,
                                        int quality);

}  // namespace hybridfusion
