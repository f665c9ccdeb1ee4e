#include "las_attributes.hpp"

#include "byte_reader.hpp"
#include "text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hybridfusion {
namespace {

constexpr std::size_t kDescriptorBytes = 192;
constexpr double kAngleStep_deg = 0.006;  // of the new formats
constexpr std::uint8_t kFirstNewFormat = 6;

/// Types 1 to 10 of a descriptor.
constexpr std::array<ScalarType, 10> kTypes = {ScalarType::kUint8,
                                               ScalarType::kInt8,
                                               ScalarType::kUint16,
                                               ScalarType::kInt16,
                                               ScalarType::kUint32,
                                               ScalarType::kInt32,
                                               ScalarType::kUint64,
                                               ScalarType::kInt64,
                                               ScalarType::kFloat32,
                                               ScalarType::kFloat64};

[[nodiscard]] std::string text_at(std::span<const std::byte> bytes) {
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return std::string(trimmed(text.substr(0, text.find('\0'))));
}

struct Attribute {
  std::string_view name;
  double LasAttributes::* member;
  ScalarType type;
};
constexpr std::array<Attribute, 12> kAttributes = {{
    {"return_number", &LasAttributes::return_number, ScalarType::kUint8},
    {"number_of_returns", &LasAttributes::number_of_returns, ScalarType::kUint8},
    {"scan_direction", &LasAttributes::scan_direction, ScalarType::kUint8},
    {"edge_of_flight_line", &LasAttributes::edge_of_flight_line, ScalarType::kUint8},
    {"classification", &LasAttributes::classification, ScalarType::kUint8},
    {"synthetic", &LasAttributes::synthetic, ScalarType::kUint8},
    {"key_point", &LasAttributes::key_point, ScalarType::kUint8},
    {"overlap", &LasAttributes::overlap, ScalarType::kUint8},
    {"scanner_channel", &LasAttributes::scanner_channel, ScalarType::kUint8},
    {"scan_angle", &LasAttributes::scan_angle_deg, ScalarType::kFloat32},
    {"user_data", &LasAttributes::user_data, ScalarType::kUint8},
    {"point_source_id", &LasAttributes::point_source_id, ScalarType::kUint16},
}};

/// A whole number of 0 to `most`.
[[nodiscard]] unsigned whole(double value, double most) {
  return value > 0.0 ? static_cast<unsigned>(std::lround(std::min(value, most))) : 0U;
}

[[nodiscard]] LasAttributes read_old(const std::byte* record) {
  const unsigned returns = load<std::uint8_t>(record + 14);
  const unsigned kind = load<std::uint8_t>(record + 15);
  return {.return_number = static_cast<double>(returns & 7U),
          .number_of_returns = static_cast<double>(returns >> 3U & 7U),
          .scan_direction = static_cast<double>(returns >> 6U & 1U),
          .edge_of_flight_line = static_cast<double>(returns >> 7U & 1U),
          .classification = static_cast<double>(kind & 31U),
          .synthetic = static_cast<double>(kind >> 5U & 1U),
          .key_point = static_cast<double>(kind >> 6U & 1U),
          .scan_angle_deg = static_cast<double>(load<std::int8_t>(record + 16)),
          .user_data = static_cast<double>(load<std::uint8_t>(record + 17)),
          .point_source_id = static_cast<double>(load<std::uint16_t>(record + 18))};
}

[[nodiscard]] LasAttributes read_new(const std::byte* record) {
  const unsigned returns = load<std::uint8_t>(record + 14);
  const unsigned flags = load<std::uint8_t>(record + 15);
  return {.return_number = static_cast<double>(returns & 15U),
          .number_of_returns = static_cast<double>(returns >> 4U),
          .scan_direction = static_cast<double>(flags >> 6U & 1U),
          .edge_of_flight_line = static_cast<double>(flags >> 7U),
          .classification = static_cast<double>(load<std::uint8_t>(record + 16)),
          .synthetic = static_cast<double>(flags & 1U),
          .key_point = static_cast<double>(flags >> 1U & 1U),
          .overlap = static_cast<double>(flags >> 3U & 1U),
          .scanner_channel = static_cast<double>(flags >> 4U & 3U),
          .scan_angle_deg = load<std::int16_t>(record + 18) * kAngleStep_deg,
          .user_data = static_cast<double>(load<std::uint8_t>(record + 17)),
          .point_source_id = static_cast<double>(load<std::uint16_t>(record + 20))};
}

}  // namespace

LasExtraFields read_las_extra_fields(std::span<const std::byte> descriptors,
                                     std::size_t begin,
                                     std::size_t end) {
  LasExtraFields extra{.end = begin};
  for (; descriptors.size() >= kDescriptorBytes; descriptors = descriptors.subspan(192)) {
    const unsigned type = load<std::uint8_t>(descriptors.data() + 2);
    const unsigned options = load<std::uint8_t>(descriptors.data() + 3);
    const std::string name = text_at(descriptors.subspan(4, 32));
    // 11 to 20 and 21 to 30 are pairs and triples of the types 1 to 10.
    const std::size_t count = type == 0 ? 0 : (type - 1) / kTypes.size() + 1;
    if (count > 3) return extra;
    const std::size_t bytes =
        type == 0 ? options : count * size_of(kTypes[(type - 1) % kTypes.size()]);
    if (extra.end + bytes > end) return extra;
    if (count == 1) {
      extra.fields.push_back({.name = name,
                              .description = text_at(descriptors.subspan(160, 32)),
                              .type = kTypes[type - 1],
                              .begin = extra.end,
                              .scaled = (options & 0x18U) != 0});
      LasExtraField& field = extra.fields.back();
      if ((options & 0x08U) != 0) field.scale = load<double>(descriptors.data() + 112);
      if ((options & 0x10U) != 0) field.offset = load<double>(descriptors.data() + 136);
    } else {
      extra.left_out.push_back(name.empty() ? "a field without a type" : name);
    }
    extra.end += bytes;
  }
  return extra;
}

std::string las_extra_descriptor(std::string_view name,
                                 std::string_view description,
                                 ScalarType type) {
  std::string out(kDescriptorBytes, '\0');
  const auto at = std::ranges::find(kTypes, type);
  out[2] = static_cast<char>(at - kTypes.begin() + 1);
  constexpr std::size_t kTextBytes = 32;
  name = name.substr(0, kTextBytes);
  description = description.substr(0, kTextBytes);
  out.replace(4, name.size(), name);
  out.replace(kDescriptorBytes - kTextBytes, description.size(), description);
  return out;
}

std::vector<CloudColumn> las_attribute_columns(std::uint8_t format) {
  std::vector<CloudColumn> columns;
  for (const Attribute& attribute : kAttributes) {
    CloudColumn column = cloud_column(attribute.name, attribute.type);
    column.uncertain = true;
    column.unsaid = LasAttributes{}.*attribute.member;
    if (attribute.member == &LasAttributes::scan_angle_deg && format < kFirstNewFormat) {
      column.type = ScalarType::kInt8;
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

void append_las_attributes(const std::byte* record, std::uint8_t format, std::vector<double>& row) {
  const LasAttributes read = format < kFirstNewFormat ? read_old(record) : read_new(record);
  for (const Attribute& attribute : kAttributes) row.push_back(read.*attribute.member);
}

std::string plain_scalar_name(std::string_view name) {
  std::string plain;
  for (const char c : lower_case(name)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) plain += c;
  }
  constexpr std::string_view kCloudCompare = "scalar";
  return plain.starts_with(kCloudCompare) ? plain.substr(kCloudCompare.size()) : plain;
}

double LasAttributes::* las_attribute(std::string_view name) {
  const std::string plain = plain_scalar_name(name);
  if (plain == "scananglerank") return &LasAttributes::scan_angle_deg;
  if (plain == "scandirectionflag") return &LasAttributes::scan_direction;
  for (const Attribute& attribute : kAttributes) {
    if (plain_scalar_name(attribute.name) == plain) return attribute.member;
  }
  return nullptr;
}

std::string las_attribute_bytes(const LasAttributes& a, bool old_format) {
  const double most_returns = old_format ? 7.0 : 15.0;
  const unsigned of_returns = old_format ? 3U : 4U;
  unsigned returns = whole(a.return_number, most_returns) | whole(a.number_of_returns, most_returns)
                                                                << of_returns;
  const unsigned ways = whole(a.scan_direction, 1.0) << 6U | whole(a.edge_of_flight_line, 1.0)
                                                                 << 7U;
  const unsigned synthetic = whole(a.synthetic, 1.0);
  const unsigned key_point = whole(a.key_point, 1.0);
  const double angle_deg = std::isfinite(a.scan_angle_deg) ? a.scan_angle_deg : 0.0;
  std::string out;
  if (old_format) {
    returns |= ways;
    constexpr double kMostClass = 31.0;
    const unsigned kind = a.classification > kMostClass ? 1U : whole(a.classification, kMostClass);
    append_value(out, static_cast<std::uint8_t>(returns));
    append_value(out, static_cast<std::uint8_t>(kind | synthetic << 5U | key_point << 6U));
    append_value(out, static_cast<std::int8_t>(std::clamp(std::round(angle_deg), -90.0, 90.0)));
    append_value(out, static_cast<std::uint8_t>(whole(a.user_data, 255.0)));
  } else {
    append_value(out, static_cast<std::uint8_t>(returns));
    append_value(
        out,
        static_cast<std::uint8_t>(synthetic | key_point << 1U | whole(a.overlap, 1.0) << 3U |
                                  whole(a.scanner_channel, 3.0) << 4U | ways));
    append_value(out, static_cast<std::uint8_t>(whole(a.classification, 255.0)));
    append_value(out, static_cast<std::uint8_t>(whole(a.user_data, 255.0)));
    append_value(out,
                 static_cast<std::int16_t>(
                     std::clamp(std::round(angle_deg / kAngleStep_deg), -30000.0, 30000.0)));
  }
  append_value(out, static_cast<std::uint16_t>(whole(a.point_source_id, 65535.0)));
  return out;
}

}  // namespace hybridfusion
