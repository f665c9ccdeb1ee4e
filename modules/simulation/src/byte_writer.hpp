#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace hybridfusion {

/// Appends little-endian values to a byte string (the host is little-endian: x86-64).
class ByteWriter {
 public:
  template <class T>
    requires std::is_arithmetic_v<T>
  void put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.append(raw, sizeof(T));
  }
  void put_bytes(std::string_view bytes) { bytes_.append(bytes); }
  /// ROS string or byte array: 32-bit length, then the bytes.
  void put_sized(std::string_view bytes) {
    put(static_cast<std::uint32_t>(bytes.size()));
    put_bytes(bytes);
  }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  void clear() { bytes_.clear(); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_ = {};
};

}  // namespace hybridfusion
