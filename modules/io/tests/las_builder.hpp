#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace hybridfusion::testing {

/// A LAS file made from the description of the format: point i lies at (100 + i, 200 + i,
/// 10 + 10 i) in units of the file.
struct LasBuilder {
  std::uint8_t minor = 2;
  std::uint8_t format = 1;
  std::uint16_t encoding = 0;  ///< Bit 0: GPS time is absolute; bit 4: WKT.
  std::uint32_t points = 4;
  std::string vlrs = {};
  std::uint32_t num_vlrs = 0;
  std::uint16_t extra_bytes = 0;

  template <class T>
  static void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof(T));
  }
  [[nodiscard]] std::uint16_t base_bytes() const {
    constexpr std::uint16_t kSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38};
    return kSizes[format];
  }
  LasBuilder& vlr(const std::string& user, std::uint16_t id, const std::string& data) {
    std::string head(54, '\0');
    head.replace(2, user.size(), user);
    put(head, 18, id);
    put(head, 20, static_cast<std::uint16_t>(data.size()));
    vlrs += head + data;
    ++num_vlrs;
    return *this;
  }
  LasBuilder& wkt(const std::string& text) {
    encoding |= 0x10U;
    return vlr("LASF_Projection", 2112, text + '\0');
  }
  LasBuilder& keys(const std::vector<std::pair<int, int>>& values) {
    std::string data(8 + 8 * values.size(), '\0');
    put(data, 0, std::uint16_t{1});
    put(data, 2, std::uint16_t{1});
    put(data, 6, static_cast<std::uint16_t>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      put(data, 8 + 8 * i, static_cast<std::uint16_t>(values[i].first));
      put(data, 12 + 8 * i, std::uint16_t{1});
      put(data, 14 + 8 * i, static_cast<std::uint16_t>(values[i].second));
    }
    return vlr("LASF_Projection", 34735, data);
  }
  /// Bytes of the file; `fill(record, i)` may change each point.
  template <class Fill>
  [[nodiscard]] std::string bytes(Fill&& fill) const {
    const std::uint16_t header = minor == 4 ? 375 : 227;
    const auto point = static_cast<std::uint16_t>(base_bytes() + extra_bytes);
    const auto begin = static_cast<std::uint32_t>(header + vlrs.size());
    std::string out(header, '\0');
    out.replace(0, 4, "LASF");
    put(out, 6, encoding);
    put(out, 24, std::uint8_t{1});
    put(out, 25, minor);
    put(out, 94, header);
    put(out, 96, begin);
    put(out, 100, num_vlrs);
    put(out, 104, format);
    put(out, 105, point);
    if (minor < 4) put(out, 107, points);
    if (minor == 4) put(out, 247, std::uint64_t{points});
    for (std::size_t axis = 0; axis < 3; ++axis) put(out, 131 + 8 * axis, 0.001);
    out += vlrs;
    for (std::uint32_t i = 0; i < points; ++i) {
      std::string record(point, '\0');
      const auto k = static_cast<std::int32_t>(i);
      put(record, 0, 100000 + 1000 * k);
      put(record, 4, 200000 + 1000 * k);
      put(record, 8, 10000 + 10000 * k);
      record[14] = format < 6 ? '\x09' : '\x11';
      record[format < 6 ? 15 : 16] = '\x01';
      fill(record, i);
      out += record;
    }
    return out;
  }
  [[nodiscard]] std::string bytes() const {
    return bytes([](std::string&, std::uint32_t) {});
  }
};

}  // namespace hybridfusion::testing
