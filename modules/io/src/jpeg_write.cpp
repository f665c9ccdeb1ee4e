#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/jpeg.hpp>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>
#include <jpeglib.h>

namespace hybridfusion {
namespace {

struct Encoder {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors = {};
  std::jmp_buf escape = {};
  char fatal[JMSG_LENGTH_MAX] = {};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's type
};

struct DestroyEncoder {
  void operator()(Encoder* encoder) const {
    jpeg_destroy_compress(&encoder->info);
    std::free(encoder->bytes);  // NOLINT: allocated by libjpeg with malloc
    delete encoder;
  }
};

[[noreturn]] void on_fatal(j_common_ptr info) {
  Encoder& encoder = *static_cast<Encoder*>(info->client_data);
  info->err->format_message(info, encoder.fatal);
  std::longjmp(encoder.escape, 1);
}

// No object with a destructor lives between setjmp and longjmp.
[[nodiscard]] bool encode(Encoder& encoder, const Image8& image, int quality) {
  if (setjmp(encoder.escape) != 0) return false;
  jpeg_create_compress(&encoder.info);
  encoder.info.client_data = &encoder;
  jpeg_mem_dest(&encoder.info, &encoder.bytes, &encoder.size);
  encoder.info.image_width = static_cast<JDIMENSION>(image.width);
  encoder.info.image_height = static_cast<JDIMENSION>(image.height);
  encoder.info.input_components = image.channels;
  encoder.info.in_color_space = image.channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
  jpeg_set_defaults(&encoder.info);
  jpeg_set_quality(&encoder.info, quality, TRUE);
  encoder.info.comp_info[0].h_samp_factor = 1;
  encoder.info.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&encoder.info, TRUE);
  const std::size_t row_bytes = static_cast<std::size_t>(image.width) * image.channels;
  while (encoder.info.next_scanline < encoder.info.image_height) {
    // libjpeg takes rows as non-const but does not write to them.
    auto* row = const_cast<JSAMPLE*>(image.pixels.data() + encoder.info.next_scanline * row_bytes);
    jpeg_write_scanlines(&encoder.info, &row, 1);
  }
  jpeg_finish_compress(&encoder.info);
  return true;
}

}  // namespace

Expected<std::string> encode_jpeg(const Image8& image, int quality) {
  HF_CHECK(image.width > 0 && image.height > 0 && (image.channels == 1 || image.channels == 3));
  HF_CHECK(image.pixels.size() ==
           static_cast<std::size_t>(image.width) * image.height * image.channels);
  HF_CHECK(quality >= 1 && quality <= 100);
  const std::unique_ptr<Encoder, DestroyEncoder> encoder(new Encoder);
  encoder->info.err = jpeg_std_error(&encoder->errors);
  encoder->info.client_data = encoder.get();
  encoder->errors.error_exit = on_fatal;
  if (!encode(*encoder, image, quality)) {
    return fail(ErrorCode::kIo,
                fmt::format("cannot encode an image of {} x {} px ({}); reduce it",
                            image.width,
                            image.height,
                            encoder->fatal));
  }
  return std::string(reinterpret_cast<const char*>(encoder->bytes), encoder->size);
}

Expected<void> write_jpeg(const std::filesystem::path& path, const Image8& image, int quality) {
  auto bytes = encode_jpeg(image, quality);
  if (!bytes) return std::unexpected(std::move(bytes.error()).with_context(path.string()));
  return write_file_atomically(path, *bytes);
}

}  // namespace hybridfusion
