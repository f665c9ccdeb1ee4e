#pragma once

#include "cloud_builder.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// A field of its own that a LAS file adds to its points (LAS 1.4 R15, section "Extra Bytes").
struct LasExtraField {
  std::string name = {};
  std::string description = {};
  ScalarType type = ScalarType::kUint8;
  std::size_t begin = 0;  ///< Place in the point.
  bool scaled = false;
  double scale = 1.0;
  double offset = 0.0;
};

struct LasExtraFields {
  std::vector<LasExtraField> fields = {};
  std::vector<std::string> left_out = {};  ///< Names of arrays and fields without a type.
  std::size_t end = 0;                     ///< Behind the last described byte.
};

/// @param begin  Where the extra bytes of a point begin. @param end  Where the point ends.
[[nodiscard]] LasExtraFields read_las_extra_fields(std::span<const std::byte> descriptors,
                                                   std::size_t begin,
                                                   std::size_t end);
/// The descriptor of an unscaled field.
[[nodiscard]] std::string las_extra_descriptor(std::string_view name,
                                               std::string_view description,
                                               ScalarType type);

/// The standard attributes of a point format beside position, intensity, colour and time.
[[nodiscard]] std::vector<CloudColumn> las_attribute_columns(std::uint8_t format);
/// Their values, in that order.
void append_las_attributes(const std::byte* record, std::uint8_t format, std::vector<double>& row);

/// What a point of a LAS file says beside position, intensity, colour and time.
struct LasAttributes {
  double return_number = 1;
  double number_of_returns = 1;
  double scan_direction = 0;
  double edge_of_flight_line = 0;
  double classification = 1;
  double synthetic = 0;
  double key_point = 0;
  double overlap = 0;
  double scanner_channel = 0;
  double scan_angle_deg = 0;
  double user_data = 0;
  double point_source_id = 0;
};

/// A name without case, signs and CloudCompare's "scalar_".
[[nodiscard]] std::string plain_scalar_name(std::string_view name);
/// The member that a scalar of this name fills, in any usual spelling; nullptr: none.
[[nodiscard]] double LasAttributes::* las_attribute(std::string_view name);
/// Bytes 14 to 17 or 19 of the old (0 to 5) or new (6 to 10) point formats, and the source.
[[nodiscard]] std::string las_attribute_bytes(const LasAttributes& attributes, bool old_format);

}  // namespace hybridfusion
