#include "input_file.hpp"
#include "jpeg_segments.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/jpeg.hpp>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>
#include <jerror.h>  // after jpeglib.h, which it needs
#include <jpeglib.h>

namespace hybridfusion {
namespace {

constexpr int kMaxSide_px = 40000;
constexpr std::int64_t kMaxPixels = 400'000'000;
// A block of 64 pixels takes at least one bit: a file that announces more is lying.
constexpr std::uint64_t kMaxPixelsPerByte = 1024;
constexpr int kMaxScans = 500;  // encoders use about ten; thousands only serve to occupy decoders

/// libjpeg's state with error handlers that leave by longjmp (fatal) or note the first damage.
struct Decoder {
  jpeg_decompress_struct info = {};
  jpeg_error_mgr errors = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf escape = {};
  char fatal[JMSG_LENGTH_MAX] = {};
  char damage[JMSG_LENGTH_MAX] = {};
};

[[nodiscard]] Decoder& decoder_of(j_common_ptr info) {
  return *static_cast<Decoder*>(info->client_data);
}

[[noreturn]] void on_fatal(j_common_ptr info) {
  Decoder& decoder = decoder_of(info);
  info->err->format_message(info, decoder.fatal);
  std::longjmp(decoder.escape, 1);
}

void on_message(j_common_ptr info, int level) {
  if (level >= 0) return;  // only traces
  const int code = info->err->msg_code;
  // Written by real cameras; the pixels are all there.
  const bool harmless =
      code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM;
  Decoder& decoder = decoder_of(info);
  if (!harmless && decoder.damage[0] == '\0') info->err->format_message(info, decoder.damage);
}

void on_progress(j_common_ptr info) {
  if (!info->is_decompressor) return;
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > kMaxScans) {
    Decoder& decoder = decoder_of(info);
    std::snprintf(decoder.fatal, sizeof(decoder.fatal), "more than %d scans", kMaxScans);
    std::longjmp(decoder.escape, 1);
  }
}

void start(Decoder& decoder) {
  decoder.info.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = on_fatal;
  decoder.errors.emit_message = on_message;
  decoder.info.client_data = &decoder;
}

// The two functions below hold no object with a destructor between setjmp and longjmp.

[[nodiscard]] bool read_header(Decoder& decoder, std::span<const std::byte> bytes) {
  if (setjmp(decoder.escape) != 0) return false;
  jpeg_create_decompress(&decoder.info);
  decoder.info.client_data = &decoder;
  decoder.progress.progress_monitor = on_progress;
  decoder.info.progress = &decoder.progress;
  jpeg_mem_src(&decoder.info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&decoder.info, TRUE);
  return true;
}

[[nodiscard]] bool read_pixels(Decoder& decoder, std::uint8_t* pixels, std::size_t row_bytes) {
  if (setjmp(decoder.escape) != 0) return false;
  decoder.info.out_color_space = JCS_RGB;
  jpeg_start_decompress(&decoder.info);
  while (decoder.info.output_scanline < decoder.info.output_height) {
    JSAMPROW row = pixels + decoder.info.output_scanline * row_bytes;
    jpeg_read_scanlines(&decoder.info, &row, 1);
  }
  jpeg_finish_decompress(&decoder.info);
  return true;
}

[[nodiscard]] std::unexpected<Error> damaged(const InputFile& file, const char* detail) {
  return file.malformed(fmt::format("truncated or damaged ({})", detail),
                        "copy the photo again from the camera");
}

Expected<void> check_header(const InputFile& file, const jpeg_decompress_struct& info) {
  const auto pixels = static_cast<std::int64_t>(info.image_width) * info.image_height;
  if (info.image_width > kMaxSide_px || info.image_height > kMaxSide_px || pixels > kMaxPixels) {
    return file.malformed(fmt::format("{} x {} pixels are more than {} a side or {} in all",
                                      info.image_width,
                                      info.image_height,
                                      kMaxSide_px,
                                      kMaxPixels),
                          "reduce the photo");
  }
  if (static_cast<std::uint64_t>(pixels) / kMaxPixelsPerByte > file.size()) {
    return damaged(file, "fewer bytes than its size needs");
  }
  if (info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK) {
    return file.malformed("its colours are CMYK", "convert the photo to RGB");
  }
  return {};
}

struct DestroyDecoder {
  void operator()(Decoder* decoder) const {
    jpeg_destroy_decompress(&decoder->info);
    delete decoder;
  }
};

}  // namespace

Expected<Image8> decode_jpeg(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const auto bytes, file.take(file.size()));
  if (bytes.size() < 2 || bytes[0] != std::byte{0xff} || bytes[1] != std::byte{0xd8}) {
    return file.malformed("not a JPEG file (it does not start with FF D8)",
                          "convert the photo to JPEG or remove the file");
  }
  const std::unique_ptr<Decoder, DestroyDecoder> decoder(new Decoder);
  start(*decoder);
  if (!read_header(*decoder, bytes)) return damaged(file, decoder->fatal);
  if (auto header = check_header(file, decoder->info); !header)
    return std::unexpected(header.error());
  Image8 image = {.width = static_cast<int>(decoder->info.image_width),
                  .height = static_cast<int>(decoder->info.image_height),
                  .channels = 3};
  const std::size_t row_bytes = static_cast<std::size_t>(image.width) * 3;
  image.pixels.resize(row_bytes * static_cast<std::size_t>(image.height));
  if (!read_pixels(*decoder, image.pixels.data(), row_bytes)) return damaged(file, decoder->fatal);
  if (decoder->damage[0] != '\0') return damaged(file, decoder->damage);
  return image;
}

Expected<ImageSize> read_jpeg_size(const std::filesystem::path& path) {
  HF_TRY(const JpegSegments segments, read_jpeg_segments(path));
  return ImageSize{.width = segments.width, .height = segments.height};
}

}  // namespace hybridfusion
