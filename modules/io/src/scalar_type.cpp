#include "scalar_type.hpp"

#include "byte_reader.hpp"

#include <array>
#include <limits>

namespace hybridfusion {

std::size_t size_of(ScalarType type) {
  constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_integer(ScalarType type) {
  return type != ScalarType::kFloat32 && type != ScalarType::kFloat64;
}

std::string_view to_string(ScalarType type) {
  constexpr std::array<std::string_view, 10> kNames = {"int8",
                                                       "uint8",
                                                       "int16",
                                                       "uint16",
                                                       "int32",
                                                       "uint32",
                                                       "float32",
                                                       "float64",
                                                       "int64",
                                                       "uint64"};
  return kNames[static_cast<std::size_t>(type)];
}

double load_scalar(const std::byte* from, ScalarType type, std::endian order) {
  switch (type) {
    case ScalarType::kInt8:
      return load<std::int8_t>(from);
    case ScalarType::kUint8:
      return load<std::uint8_t>(from);
    case ScalarType::kInt16:
      return load<std::int16_t>(from, order);
    case ScalarType::kUint16:
      return load<std::uint16_t>(from, order);
    case ScalarType::kInt32:
      return load<std::int32_t>(from, order);
    case ScalarType::kUint32:
      return load<std::uint32_t>(from, order);
    case ScalarType::kFloat32:
      return load<float>(from, order);
    case ScalarType::kFloat64:
      return load<double>(from, order);
    case ScalarType::kInt64:
      return static_cast<double>(load<std::int64_t>(from, order));
    case ScalarType::kUint64:
      return static_cast<double>(load<std::uint64_t>(from, order));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hybridfusion
