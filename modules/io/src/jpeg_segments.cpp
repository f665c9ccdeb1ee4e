#include "jpeg_segments.hpp"

#include "byte_reader.hpp"
#include "input_file.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::byte kMarker{0xff};
constexpr std::uint8_t kStartOfImage = 0xd8;
constexpr std::uint8_t kEndOfImage = 0xd9;
constexpr std::uint8_t kStartOfScan = 0xda;
constexpr std::uint8_t kApp1 = 0xe1;
constexpr std::string_view kAgain = "copy the photo again from the camera";

/// SOF0 .. SOF15 without DHT, JPG and DAC, which share the range.
[[nodiscard]] bool is_frame_header(std::uint8_t marker) {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

[[nodiscard]] bool has_no_length(std::uint8_t marker) {
  return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
}

/// The next marker; fill bytes (repeated 0xff) are allowed before it.
Expected<std::uint8_t> read_marker(InputFile& file) {
  HF_TRY(auto bytes, file.take(2));
  if (bytes[0] != kMarker) {
    return file.malformed(fmt::format("damaged: no marker at byte {}", file.position() - 2),
                          kAgain);
  }
  std::byte code = bytes[1];
  while (code == kMarker) {
    HF_TRY(bytes, file.take(1));
    code = bytes[0];
  }
  return static_cast<std::uint8_t>(code);
}

void keep_app1(std::span<const std::byte> data, JpegSegments& segments) {
  constexpr std::string_view kExif("Exif\0\0", 6);
  constexpr std::string_view kXmp("http://ns.adobe.com/xap/1.0/\0", 29);
  const std::string_view text(reinterpret_cast<const char*>(data.data()), data.size());
  if (text.starts_with(kExif) && segments.exif.empty()) {
    segments.exif.assign(data.begin() + kExif.size(), data.end());
  } else if (text.starts_with(kXmp) && segments.xmp.empty()) {
    segments.xmp = text.substr(kXmp.size());
  }
}

}  // namespace

Expected<JpegSegments> read_jpeg_segments(const std::filesystem::path& path) {
  HF_TRY(InputFile file, InputFile::open(path));
  const auto start = file.take(2);
  if (!start || (*start)[0] != kMarker || (*start)[1] != std::byte{kStartOfImage}) {
    return file.malformed("not a JPEG file (it does not start with FF D8)",
                          "convert the photo to JPEG or remove the file");
  }
  JpegSegments segments;
  for (;;) {
    HF_TRY(const std::uint8_t marker, read_marker(file));
    if (has_no_length(marker)) continue;
    if (marker == kEndOfImage) return file.malformed("damaged: it ends before any pixels", kAgain);
    HF_TRY(const auto length, file.take(2));
    const auto bytes = load<std::uint16_t>(length.data(), std::endian::big);
    if (bytes < 2) {
      return file.malformed(fmt::format("damaged: a segment of {} bytes", bytes), kAgain);
    }
    HF_TRY(const auto data, file.take(bytes - 2U));
    if (marker == kApp1) keep_app1(data, segments);
    if (is_frame_header(marker) && data.size() >= 5) {
      segments.height = load<std::uint16_t>(data.data() + 1, std::endian::big);
      segments.width = load<std::uint16_t>(data.data() + 3, std::endian::big);
    }
    if (marker == kStartOfScan) break;
  }
  if (segments.width == 0 || segments.height == 0) {
    return file.malformed("damaged: it does not say how large the image is", kAgain);
  }
  segments.scan_begin = file.position();
  return segments;
}

Expected<bool> has_end_marker(const std::filesystem::path& path, std::uint64_t scan_begin) {
  constexpr std::uint64_t kTailBytes = 65536;
  HF_TRY(InputFile file, InputFile::open(path));
  const std::uint64_t tail = file.size() > kTailBytes ? file.size() - kTailBytes : 0;
  file.seek(std::max(scan_begin, tail));
  HF_TRY(const auto bytes, file.take(file.remaining()));
  constexpr std::array kEnd = {kMarker, std::byte{kEndOfImage}};
  return !std::ranges::search(bytes, kEnd).empty();
}

}  // namespace hybridfusion
