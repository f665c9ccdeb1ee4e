#pragma once

#include "sample_cloud.hpp"
#include "test_files.hpp"

#include <hybridfusion/io/jpeg.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace hybridfusion::testing {

/// Builds the TIFF structure of an EXIF segment.
class ExifBuilder {
 public:
  enum Directory { kImage, kPhoto, kGps };
  explicit ExifBuilder(std::endian order) : order_(order) {}

  void text(Directory directory, std::uint16_t tag, const std::string& value) {
    add(directory, tag, 2, static_cast<std::uint32_t>(value.size() + 1), value + '\0');
  }
  void bytes(Directory directory, std::uint16_t tag, const std::vector<std::uint8_t>& values) {
    add(directory,
        tag,
        1,
        static_cast<std::uint32_t>(values.size()),
        {values.begin(), values.end()});
  }
  void shorts(Directory directory, std::uint16_t tag, const std::vector<std::uint16_t>& values) {
    std::string data;
    for (const std::uint16_t value : values) data += bytes_of(value, order_);
    add(directory, tag, 3, static_cast<std::uint32_t>(values.size()), data);
  }
  void rationals(Directory directory,
                 std::uint16_t tag,
                 const std::vector<std::pair<std::uint32_t, std::uint32_t>>& values) {
    std::string data;
    for (const auto& [over, under] : values)
      data += bytes_of(over, order_) + bytes_of(under, order_);
    add(directory, tag, 5, static_cast<std::uint32_t>(values.size()), data);
  }

  [[nodiscard]] std::string build() const {
    // Fixed places: directories of up to 30 entries, then their values.
    constexpr std::uint32_t kDirectoryBytes = 2 + 30 * 12 + 4;
    const auto directory_at = [](int i) {
      return 8 + static_cast<std::uint32_t>(i) * kDirectoryBytes;
    };
    std::string out = order_ == std::endian::little ? "II" : "MM";
    out += bytes_of(std::uint16_t{42}, order_) + bytes_of(std::uint32_t{8}, order_);
    std::string values;
    for (int d = 0; d < 3; ++d) {
      auto entries = entries_[d];
      if (d == kImage) {
        entries[0x8769] = {4, 1, bytes_of(directory_at(kPhoto), order_)};
        entries[0x8825] = {4, 1, bytes_of(directory_at(kGps), order_)};
      }
      std::string directory = bytes_of(static_cast<std::uint16_t>(entries.size()), order_);
      for (const auto& [tag, entry] : entries) {
        directory +=
            bytes_of(tag, order_) + bytes_of(entry.type, order_) + bytes_of(entry.count, order_);
        std::string field = entry.data;
        if (field.size() > 4) {
          const auto at = directory_at(3) + static_cast<std::uint32_t>(values.size());
          values += field;
          field = bytes_of(at, order_);
        }
        field.resize(4, '\0');
        directory += field;
      }
      // A next-pointer into nowhere, as some cameras write it.
      directory += bytes_of(std::uint32_t{0xdeadbeef}, order_);
      directory.resize(kDirectoryBytes, '\0');
      out += directory;
    }
    return out + values;
  }

 private:
  struct Entry {
    std::uint16_t type = 0;
    std::uint32_t count = 0;
    std::string data;
  };
  void add(Directory directory,
           std::uint16_t tag,
           std::uint16_t type,
           std::uint32_t count,
           std::string data) {
    entries_[directory][tag] = {type, count, std::move(data)};
  }
  std::endian order_;
  std::array<std::map<std::uint16_t, Entry>, 3> entries_ = {};
};

/// 64 x 48 pixels of a smooth pattern.
[[nodiscard]] inline Image8 sample_image(int channels = 3) {
  Image8 image = {.width = 64, .height = 48, .channels = channels};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < channels; ++c) {
        image.pixels.push_back(static_cast<std::uint8_t>(2 * x + y + 30 * c));
      }
    }
  }
  return image;
}

/// Bytes of a JPEG with the given metadata.
[[nodiscard]] inline std::string sample_jpeg(const std::string& exif = {},
                                             const std::string& xmp = {}) {
  const TempFolder folder;
  EXPECT_TRUE(write_jpeg(folder.path() / "a.jpg", sample_image(), 95));
  std::string jpeg = content_of(folder.path() / "a.jpg");
  const auto insert = [&jpeg](const std::string& data) {
    jpeg.insert(2,
                "\xff\xe1" +
                    bytes_of(static_cast<std::uint16_t>(data.size() + 2), std::endian::big) + data);
  };
  if (!xmp.empty()) insert(std::string("http://ns.adobe.com/xap/1.0/\0", 29) + xmp);
  if (!exif.empty()) insert(std::string("Exif\0\0", 6) + exif);
  return jpeg;
}

}  // namespace hybridfusion::testing
