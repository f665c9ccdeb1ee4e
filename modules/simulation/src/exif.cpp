#include "byte_writer.hpp"
#include "jpeg_photo.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

enum class TiffType : std::uint16_t { kByte = 1, kAscii = 2, kShort = 3, kLong = 4, kRational = 5 };

struct Entry {
  std::uint16_t tag;
  TiffType type;
  std::uint32_t count;
  std::string data;
};

Entry ascii(std::uint16_t tag, std::string text) {
  text.push_back('\0');
  return {tag, TiffType::kAscii, static_cast<std::uint32_t>(text.size()), text};
}
Entry number(std::uint16_t tag, TiffType type, std::uint32_t value) {
  ByteWriter out;
  if (type == TiffType::kShort) {
    out.put(static_cast<std::uint16_t>(value));
  } else {
    out.put(value);
  }
  return {tag, type, 1, out.take()};
}
Entry bytes(std::uint16_t tag, std::string data) {
  return {tag, TiffType::kByte, static_cast<std::uint32_t>(data.size()), data};
}
struct Ratio {
  double value;
  std::uint32_t denominator;
};
Entry rationals(std::uint16_t tag, std::initializer_list<Ratio> values) {
  ByteWriter out;
  for (const Ratio& ratio : values) {
    out.put(static_cast<std::uint32_t>(std::llround(ratio.value * ratio.denominator)));
    out.put(ratio.denominator);
  }
  return {tag, TiffType::kRational, static_cast<std::uint32_t>(values.size()), out.take()};
}

/// Degrees, minutes and seconds to a millionth of a second (0.03 mm).
Entry angle(std::uint16_t tag, double degrees) {
  const auto total = static_cast<std::int64_t>(std::llround(std::abs(degrees) * 3600e6));
  const auto whole_degrees = static_cast<double>(total / 3'600'000'000);
  const auto minutes = static_cast<double>(total / 60'000'000 % 60);
  const double seconds = 1e-6 * static_cast<double>(total % 60'000'000);
  return rationals(tag, {{whole_degrees, 1}, {minutes, 1}, {seconds, 1'000'000}});
}

std::size_t directory_size(const std::vector<Entry>& entries) {
  std::size_t size = 2 + 12 * entries.size() + 4;
  for (const Entry& entry : entries) {
    if (entry.data.size() > 4) size += entry.data.size() + entry.data.size() % 2;
  }
  return size;
}

/// Entries, then the values that do not fit into them. @param start  Offset in the TIFF.
std::string directory(const std::vector<Entry>& entries, std::size_t start) {
  ByteWriter table;
  ByteWriter values;
  const std::size_t values_start = start + 2 + 12 * entries.size() + 4;
  table.put(static_cast<std::uint16_t>(entries.size()));
  for (const Entry& entry : entries) {
    table.put(entry.tag);
    table.put(static_cast<std::uint16_t>(entry.type));
    table.put(entry.count);
    if (entry.data.size() <= 4) {
      table.put_bytes(entry.data);
      table.put_bytes(std::string(4 - entry.data.size(), '\0'));
    } else {
      table.put(static_cast<std::uint32_t>(values_start + values.size()));
      values.put_bytes(entry.data);
      if (entry.data.size() % 2 == 1) values.put_bytes(std::string(1, '\0'));
    }
  }
  table.put(std::uint32_t{0});
  return table.take() + values.take();
}

/// A time as EXIF writes it.
struct TakenAt {
  std::string date = {};   ///< "2025:06:01".
  std::string clock = {};  ///< "12:34:56".
  std::array<double, 3> hours_minutes_seconds = {};
  std::string milliseconds = {};
};

TakenAt taken_at(Timestamp time) {
  using namespace std::chrono;
  const sys_time<nanoseconds> moment{time};
  const auto day = floor<days>(moment);
  const year_month_day date{day};
  const hh_mm_ss clock{floor<std::chrono::milliseconds>(moment - day)};
  return {.date = fmt::format("{:04}:{:02}:{:02}",
                              static_cast<int>(date.year()),
                              static_cast<unsigned>(date.month()),
                              static_cast<unsigned>(date.day())),
          .clock = fmt::format("{:02}:{:02}:{:02}",
                               clock.hours().count(),
                               clock.minutes().count(),
                               clock.seconds().count()),
          .hours_minutes_seconds = {static_cast<double>(clock.hours().count()),
                                    static_cast<double>(clock.minutes().count()),
                                    static_cast<double>(clock.seconds().count())},
          .milliseconds = fmt::format("{:03}", clock.subseconds().count())};
}

std::vector<Entry> exif_entries(const ExifFields& f, const TakenAt& taken) {
  using enum TiffType;
  return {rationals(0x829A, {{1.0 / 800.0, 800}}),
          rationals(0x829D, {{2.8, 10}}),
          number(0x8827, kShort, 100),
          ascii(0x9003, taken.date + ' ' + taken.clock),
          rationals(0x920A, {{f.focal_mm, 1000}}),
          ascii(0x9291, taken.milliseconds),
          number(0xA002, kLong, static_cast<std::uint32_t>(f.width_px)),
          number(0xA003, kLong, static_cast<std::uint32_t>(f.height_px)),
          number(0xA405, kShort, static_cast<std::uint32_t>(std::lround(f.focal_35mm)))};
}

std::vector<Entry> gps_entries(const ExifFields& f, const TakenAt& taken) {
  const auto& [hours, minutes, seconds] = taken.hours_minutes_seconds;
  return {bytes(0x0000, std::string("\2\3\0\0", 4)),
          ascii(0x0001, f.position.latitude_deg >= 0 ? "N" : "S"),
          angle(0x0002, f.position.latitude_deg),
          ascii(0x0003, f.position.longitude_deg >= 0 ? "E" : "W"),
          angle(0x0004, f.position.longitude_deg),
          bytes(0x0005, std::string(1, f.position.altitude_m < 0 ? '\1' : '\0')),
          rationals(0x0006, {{std::abs(f.position.altitude_m), 1000}}),
          rationals(0x0007, {{hours, 1}, {minutes, 1}, {seconds, 1}}),
          ascii(0x0012, "WGS-84"),
          ascii(0x001D, taken.date),
          rationals(0x001F, {{f.horizontal_error_m, 1000}})};
}

}  // namespace

std::string exif_segment(const ExifFields& f) {
  const TakenAt taken = taken_at(f.time);
  std::vector<Entry> image = {ascii(0x010F, "CVSIM"),
                              ascii(0x0110, "SIM-Drone-1"),
                              number(0x0112, TiffType::kShort, 1),
                              ascii(0x0132, taken.date + ' ' + taken.clock),
                              number(0x8769, TiffType::kLong, 0),
                              number(0x8825, TiffType::kLong, 0)};
  const std::vector<Entry> exif = exif_entries(f, taken);
  const std::vector<Entry> gps = gps_entries(f, taken);
  constexpr std::size_t kMainStart = 8;
  const std::size_t exif_start = kMainStart + directory_size(image);
  const std::size_t gps_start = exif_start + directory_size(exif);
  image[4] = number(0x8769, TiffType::kLong, static_cast<std::uint32_t>(exif_start));
  image[5] = number(0x8825, TiffType::kLong, static_cast<std::uint32_t>(gps_start));
  ByteWriter out;
  out.put_bytes(std::string_view("Exif\0\0", 6));
  out.put_bytes("II");
  out.put(std::uint16_t{42});
  out.put(static_cast<std::uint32_t>(kMainStart));
  out.put_bytes(directory(image, kMainStart));
  out.put_bytes(directory(exif, exif_start));
  out.put_bytes(directory(gps, gps_start));
  return out.take();
}

}  // namespace hybridfusion
