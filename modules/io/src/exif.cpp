#include "exif.hpp"

#include "byte_reader.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace hybridfusion {
namespace {

constexpr std::uint16_t kPhotoDirectory = 0x8769;
constexpr std::uint16_t kGpsDirectory = 0x8825;
constexpr std::uint16_t kMaxEntries = 1024;
constexpr std::size_t kEntryBytes = 12;

enum TiffType : std::uint16_t {
  kByte = 1,
  kAscii = 2,
  kShort = 3,
  kLong = 4,
  kRational = 5,
  kSignedByte = 6,
  kUndefined = 7,
  kSignedShort = 8,
  kSignedLong = 9,
  kSignedRational = 10,
  kFloat = 11,
  kDouble = 12
};

/// Bytes of one value; 0 for an unknown type.
[[nodiscard]] std::uint64_t size_of(std::uint16_t type) {
  constexpr std::array<std::uint64_t, 13> kSizes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};
  return type < kSizes.size() ? kSizes[type] : 0;
}

[[nodiscard]] std::optional<double> ratio(double numerator, double denominator) {
  if (denominator == 0.0) return std::nullopt;
  return numerator / denominator;
}

}  // namespace

Exif::Exif(std::span<const std::byte> tiff) : tiff_(tiff) {
  if (tiff.size() < 8) return;
  const std::string_view mark(reinterpret_cast<const char*>(tiff.data()), 2);
  if (mark != "II" && mark != "MM") return;
  order_ = mark == "MM" ? std::endian::big : std::endian::little;
  read_directory(ExifDirectory::kImage, load<std::uint32_t>(tiff.data() + 4, order_));
  const auto follow = [this](std::uint16_t tag, ExifDirectory directory) {
    const auto offset = number(ExifDirectory::kImage, tag);
    if (offset && *offset >= 0.0) read_directory(directory, static_cast<std::uint64_t>(*offset));
  };
  follow(kPhotoDirectory, ExifDirectory::kPhoto);
  follow(kGpsDirectory, ExifDirectory::kGps);
}

void Exif::read_directory(ExifDirectory directory, std::uint64_t offset) {
  if (offset > tiff_.size() || tiff_.size() - offset < 2) return;
  const auto count = load<std::uint16_t>(tiff_.data() + offset, order_);
  const std::size_t fitting = (tiff_.size() - offset - 2) / kEntryBytes;
  for (std::size_t i = 0; i < std::min({std::size_t{count}, fitting, std::size_t{kMaxEntries}});
       ++i) {
    const std::byte* const raw = tiff_.data() + offset + 2 + i * kEntryBytes;
    Entry entry = {.directory = directory,
                   .tag = load<std::uint16_t>(raw, order_),
                   .type = load<std::uint16_t>(raw + 2, order_),
                   .count = load<std::uint32_t>(raw + 4, order_)};
    const std::uint64_t bytes = size_of(entry.type) * entry.count;
    // Values of up to four bytes stand in the entry itself.
    const std::uint64_t at = bytes <= 4 ? static_cast<std::uint64_t>(raw + 8 - tiff_.data())
                                        : load<std::uint32_t>(raw + 8, order_);
    if (bytes == 0 || at > tiff_.size() || bytes > tiff_.size() - at) continue;
    entry.bytes = tiff_.subspan(at, bytes);
    entries_.push_back(entry);
  }
}

const Exif::Entry* Exif::find(ExifDirectory directory, std::uint16_t tag) const {
  for (const Entry& entry : entries_) {
    if (entry.directory == directory && entry.tag == tag) return &entry;
  }
  return nullptr;
}

std::optional<double> Exif::number(ExifDirectory directory,
                                   std::uint16_t tag,
                                   std::size_t index) const {
  const Entry* const entry = find(directory, tag);
  if (entry == nullptr || index >= entry->count) return std::nullopt;
  const std::byte* const at = entry->bytes.data() + index * size_of(entry->type);
  switch (entry->type) {
    case kByte:
    case kUndefined:
      return load<std::uint8_t>(at);
    case kSignedByte:
      return load<std::int8_t>(at);
    case kShort:
      return load<std::uint16_t>(at, order_);
    case kSignedShort:
      return load<std::int16_t>(at, order_);
    case kLong:
      return load<std::uint32_t>(at, order_);
    case kSignedLong:
      return load<std::int32_t>(at, order_);
    case kRational:
      return ratio(load<std::uint32_t>(at, order_), load<std::uint32_t>(at + 4, order_));
    case kSignedRational:
      return ratio(load<std::int32_t>(at, order_), load<std::int32_t>(at + 4, order_));
    case kFloat:
      return load<float>(at, order_);
    case kDouble:
      return load<double>(at, order_);
    default:
      return std::nullopt;
  }
}

std::string Exif::text(ExifDirectory directory, std::uint16_t tag) const {
  const Entry* const entry = find(directory, tag);
  if (entry == nullptr ||
      (entry->type != kAscii && entry->type != kByte && entry->type != kUndefined)) {
    return {};
  }
  const std::string_view all(reinterpret_cast<const char*>(entry->bytes.data()),
                             entry->bytes.size());
  return std::string(trimmed(all.substr(0, all.find('\0'))));
}

}  // namespace hybridfusion
