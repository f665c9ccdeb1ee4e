#include "jpeg_photo.hpp"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <jpeglib.h>

namespace hybridfusion {
namespace {

/// libjpeg's errors leave through longjmp; nothing with a destructor lives across it.
struct ErrorManager {
  jpeg_error_mgr base;
  std::jmp_buf jump;
};

[[noreturn]] void leave(j_common_ptr info) {
  std::longjmp(reinterpret_cast<ErrorManager*>(info->err)->jump, 1);
}

/// @returns false when libjpeg gave up; `buffer` is then still to be freed.
bool compress(const Image8& image,
              int quality,
              const unsigned char* exif,
              std::size_t exif_size,
              unsigned char** buffer,
              unsigned long* size) {
  jpeg_compress_struct info{};
  ErrorManager errors{};
  info.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = leave;
  if (setjmp(errors.jump) != 0) {
    jpeg_destroy_compress(&info);
    return false;
  }
  jpeg_create_compress(&info);
  jpeg_mem_dest(&info, buffer, size);
  info.image_width = static_cast<JDIMENSION>(image.width);
  info.image_height = static_cast<JDIMENSION>(image.height);
  info.input_components = image.channels;
  info.in_color_space = image.channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  jpeg_start_compress(&info, TRUE);
  if (exif_size > 0) {
    jpeg_write_marker(&info, JPEG_APP0 + 1, exif, static_cast<unsigned>(exif_size));
  }
  const std::size_t stride = static_cast<std::size_t>(image.width) * image.channels;
  while (info.next_scanline < info.image_height) {
    // libjpeg's interface is not const-correct; it does not write to the rows.
    JSAMPROW row = const_cast<JSAMPROW>(image.pixels.data() + info.next_scanline * stride);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  return true;
}

}  // namespace

Expected<std::string> encode_jpeg(const Image8& image, int quality, const std::string& exif) {
  HF_CHECK(image.pixels.size() ==
           static_cast<std::size_t>(image.width) * image.height * image.channels);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  const bool good = compress(image,
                             quality,
                             reinterpret_cast<const unsigned char*>(exif.data()),
                             exif.size(),
                             &buffer,
                             &size);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(buffer, &std::free);
  if (!good) return fail(ErrorCode::kIo, "libjpeg could not encode a photo");
  return std::string(reinterpret_cast<const char*>(buffer), size);
}

}  // namespace hybridfusion
