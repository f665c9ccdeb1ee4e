#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hybridfusion {

/// Number types of point fields, in the order of sensor_msgs/PointField (which counts from 1).
enum class ScalarType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64,
  kInt64,  ///< Not in PointField.
  kUint64
};

[[nodiscard]] std::size_t size_of(ScalarType type);
[[nodiscard]] bool is_integer(ScalarType type);
[[nodiscard]] std::string_view to_string(ScalarType type);
/// Value at `from`, which has size_of(type) readable bytes. Exact but for 64-bit integers
/// above 2^53.
[[nodiscard]] double load_scalar(const std::byte* from, ScalarType type, std::endian order);

}  // namespace hybridfusion
