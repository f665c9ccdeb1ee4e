#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace hybridfusion {

static_assert(std::endian::native == std::endian::little,
              "the readers and writers copy little-endian values as they are");

/// Value with its bytes reversed.
template <class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] T byte_swapped(T value) {
  std::byte bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// Unaligned load. @pre sizeof(T) readable bytes at `from`
template <class T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] T load(const std::byte* from, std::endian order = std::endian::little) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return order == std::endian::little ? value : byte_swapped(value);
}

/// Cursor over bytes of unknown trustworthiness. A read past the end yields zeros and sets
/// `failed()`, which the caller asks once after a group of reads.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes, std::endian order = std::endian::little)
      : bytes_(bytes), order_(order) {}

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] std::endian order() const { return order_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }

  template <class T>
  [[nodiscard]] T read() {
    const auto bytes = take(sizeof(T));
    return bytes.empty() ? T{} : load<T>(bytes.data(), order_);
  }

  /// The next `count` bytes; empty (and failed) when fewer remain.
  [[nodiscard]] std::span<const std::byte> take(std::uint64_t count) {
    if (failed_ || count > remaining()) {
      failed_ = true;
      return {};
    }
    const auto result = bytes_.subspan(position_, count);
    position_ += count;
    return result;
  }

  /// Text of a 32-bit length and that many bytes (ROS 1 string).
  [[nodiscard]] std::string_view read_string() {
    const auto length = read<std::uint32_t>();
    const auto bytes = take(length);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  void skip(std::uint64_t count) { static_cast<void>(take(count)); }

 private:
  std::span<const std::byte> bytes_;
  std::endian order_;
  std::size_t position_ = 0;
  bool failed_ = false;
};

/// Appends the bytes of `value` (little-endian).
template <class T>
  requires std::is_arithmetic_v<T>
void append_value(std::string& buffer, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  buffer.append(bytes, sizeof(T));
}

}  // namespace hybridfusion
