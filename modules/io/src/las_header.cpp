#include "las_header.hpp"

#include "byte_reader.hpp"
#include "text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "copy or export the file again";
constexpr std::uint64_t kHeader10 = 227;
constexpr std::uint64_t kHeader14 = 375;
constexpr std::uint64_t kVlrBytes = 54;
constexpr std::uint64_t kEvlrBytes = 60;
constexpr std::uint64_t kMaxRecordBytes = std::uint64_t{1} << 24;

[[nodiscard]] std::string text_of(std::span<const std::byte> bytes) {
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.substr(0, text.find('\0'));
}

void take_record(std::string_view user,
                 std::uint16_t id,
                 std::span<const std::byte> data,
                 LasHeader& header,
                 LasCrsRecords& records) {
  if (user == "LASF_Projection" && id == 2112) records.wkt = text_of(data);
  if (user == "LASF_Projection" && id == 34735) records.geo_keys.assign(data.begin(), data.end());
  if (user == "LASF_Projection" && id == 34736) {
    records.geo_doubles.assign(data.begin(), data.end());
  }
  if (user == "LASF_Projection" && id == 34737) {
    records.geo_ascii.assign(reinterpret_cast<const char*>(data.data()), data.size());
  }
  if (user == "LASF_Spec" && id == 4) {
    header.extra =
        read_las_extra_fields(data, kLasLayouts[header.point_format].bytes, header.point_bytes);
  }
}

Expected<void> read_vlrs(InputFile& file,
                         std::uint64_t begin,
                         std::uint32_t count,
                         LasHeader& header,
                         LasCrsRecords& records) {
  file.seek(begin);
  // A count that lies ends where the points begin.
  for (std::uint32_t i = 0; i < count; ++i) {
    if (file.position() + kVlrBytes > header.points_begin) return {};
    HF_TRY(const auto head, file.take(kVlrBytes));
    const std::string user = text_of(head.subspan(2, 16));
    const auto id = load<std::uint16_t>(head.data() + 18);
    const auto bytes = load<std::uint16_t>(head.data() + 20);
    if (bytes > header.points_begin - file.position()) return {};
    HF_TRY(const auto data, file.take(bytes));
    take_record(user, id, data, header, records);
  }
  return {};
}

Expected<void> read_evlrs(InputFile& file,
                          std::uint64_t begin,
                          std::uint32_t count,
                          LasHeader& header,
                          LasCrsRecords& records) {
  if (begin < header.points_begin || begin >= file.size()) return {};
  file.seek(begin);
  for (std::uint32_t i = 0; i < count && file.remaining() >= kEvlrBytes; ++i) {
    HF_TRY(const auto head, file.take(kEvlrBytes));
    const std::string user = text_of(head.subspan(2, 16));
    const auto id = load<std::uint16_t>(head.data() + 18);
    const auto bytes = load<std::uint64_t>(head.data() + 20);
    if (bytes > file.remaining()) return {};
    const bool wanted = user == "LASF_Projection" || user == "LASF_Spec";
    if (!wanted || bytes > kMaxRecordBytes) {
      if (auto skipped = file.skip(bytes); !skipped) return skipped;
      continue;
    }
    HF_TRY(const auto data, file.take(bytes));
    take_record(user, id, data, header, records);
  }
  return {};
}

Expected<void> check(const InputFile& file, const LasHeader& header) {
  if ((header.point_format & 0xc0U) != 0) {
    return file.malformed("a compressed file (LAZ)", "unpack it to LAS first (laszip, pdal)");
  }
  if (header.point_format >= kLasLayouts.size() ||
      header.point_bytes < kLasLayouts[header.point_format].bytes) {
    return file.malformed(
        fmt::format(
            "point format {} with {} bytes a point", header.point_format, header.point_bytes),
        kAgain);
  }
  if (header.points_begin > file.size() ||
      header.points > (file.size() - header.points_begin) / header.point_bytes) {
    return file.malformed(
        fmt::format("truncated: {} points of {} bytes are announced from byte {} of {}",
                    header.points,
                    header.point_bytes,
                    header.points_begin,
                    file.size()),
        kAgain);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double largest = std::abs(header.scale[axis]) * 2147483648.0;
    if (!(std::isfinite(largest) && largest > 0.0 && std::isfinite(header.offset[axis]))) {
      return file.malformed("scale or offset of the coordinates is not usable", kAgain);
    }
  }
  return {};
}

}  // namespace

Expected<LasHeader> read_las_header(InputFile& file) {
  if (file.size() < kHeader10) {
    return file.malformed("not a LAS file (shorter than its header)", kAgain);
  }
  HF_TRY(const auto taken, file.take(std::min(file.size(), kHeader14)));
  const std::vector<std::byte> bytes(taken.begin(), taken.end());
  if (text_of(std::span(bytes).first(4)) != "LASF") {
    return file.malformed("not a LAS file (it does not start with 'LASF')", "give a .las file");
  }
  const auto at = [&bytes]<class T>(T, std::size_t place) { return load<T>(bytes.data() + place); };
  const std::uint8_t minor = at(std::uint8_t{}, 25);
  const std::uint16_t header_bytes = at(std::uint16_t{}, 94);
  const bool is14 = minor >= 4 && header_bytes >= kHeader14 && bytes.size() >= kHeader14;
  if (at(std::uint8_t{}, 24) != 1 || minor > 4 || (minor == 4 && !is14)) {
    return file.malformed(
        fmt::format("LAS version {}.{} with a header of {} bytes; 1.0 to 1.4 are read",
                    at(std::uint8_t{}, 24),
                    minor,
                    header_bytes),
        kAgain);
  }
  LasHeader header = {.point_format = at(std::uint8_t{}, 104),
                      .point_bytes = at(std::uint16_t{}, 105),
                      .points = at(std::uint32_t{}, 107),
                      .points_begin = at(std::uint32_t{}, 96),
                      .absolute_time = (at(std::uint16_t{}, 6) & 1U) != 0};
  if (is14 && at(std::uint64_t{}, 247) != 0) header.points = at(std::uint64_t{}, 247);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = at(double{}, 131 + 8 * axis);
    header.offset[axis] = at(double{}, 155 + 8 * axis);
  }
  if (auto sound = check(file, header); !sound) return std::unexpected(sound.error());
  LasCrsRecords records{.wkt_rules = (at(std::uint16_t{}, 6) & 0x10U) != 0};
  header.extra.end = kLasLayouts[header.point_format].bytes;
  auto read = read_vlrs(file, header_bytes, at(std::uint32_t{}, 100), header, records);
  if (read && is14) {
    read = read_evlrs(file, at(std::uint64_t{}, 235), at(std::uint32_t{}, 243), header, records);
  }
  if (!read) return std::unexpected(read.error());
  HF_TRY(header.crs, las_crs(file, records));
  return header;
}

}  // namespace hybridfusion
