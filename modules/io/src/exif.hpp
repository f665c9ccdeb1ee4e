#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

enum class ExifDirectory : std::uint8_t { kImage, kPhoto, kGps };

/// Values of the EXIF of a photo (Exif 2.32, CIPA DC-008). Written for the damage that cameras and
/// editors leave: every offset is checked, a broken entry costs only itself, links to further
/// directories are not followed. Rationals keep full precision (GDAL prints six digits: 11 m for a
/// latitude in decimal degrees).
class Exif {
 public:
  /// @param tiff  Content of the Exif segment, from the byte order mark on. Must outlive the
  /// object.
  explicit Exif(std::span<const std::byte> tiff);

  /// Value `index` of a tag; nothing when it is absent, not a number, or n/0.
  [[nodiscard]] std::optional<double> number(ExifDirectory directory,
                                             std::uint16_t tag,
                                             std::size_t index = 0) const;
  /// Trimmed text up to the first NUL; empty when absent.
  [[nodiscard]] std::string text(ExifDirectory directory, std::uint16_t tag) const;

 private:
  struct Entry {
    ExifDirectory directory = ExifDirectory::kImage;
    std::uint16_t tag = 0;
    std::uint16_t type = 0;
    std::uint32_t count = 0;
    std::span<const std::byte> bytes = {};
  };
  void read_directory(ExifDirectory directory, std::uint64_t offset);
  [[nodiscard]] const Entry* find(ExifDirectory directory, std::uint16_t tag) const;

  std::span<const std::byte> tiff_;
  std::endian order_ = std::endian::little;
  std::vector<Entry> entries_ = {};
};

}  // namespace hybridfusion
