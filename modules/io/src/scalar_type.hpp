#pragma once

#include <hybridfusion/io/point_scalar.hpp>

#include <bit>
#include <cstddef>
#include <string_view>

namespace hybridfusion {

[[nodiscard]] std::size_t size_of(ScalarType type);
[[nodiscard]] bool is_integer(ScalarType type);
[[nodiscard]] std::string_view to_string(ScalarType type);
/// Value at `from`, which has size_of(type) readable bytes. Exact but for 64-bit integers
/// above 2^53.
[[nodiscard]] double load_scalar(const std::byte* from, ScalarType type, std::endian order);

}  // namespace hybridfusion
