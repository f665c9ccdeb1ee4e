#pragma once

#include "byte_reader.hpp"

#include <hybridfusion/io/ros_wire.hpp>

#include <algorithm>

namespace hybridfusion {

/// Cursor over a serialised message, the same for ROS 1 and for ROS 2 (OMG DDSI-RTPS 10.5: plain
/// CDR, version 1). As with ByteReader, failed() is asked once after a group of reads.
class RosReader {
 public:
  RosReader(std::span<const std::byte> message, RosWire wire)
      : wire_(wire), reader_(body_of(message, wire), order_of(message, wire)) {
    if (wire == RosWire::kCdr && !is_plain_cdr(message)) reader_.skip(reader_.remaining() + 1);
  }

  [[nodiscard]] RosWire wire() const { return wire_; }
  [[nodiscard]] bool failed() const { return reader_.failed(); }
  [[nodiscard]] std::size_t remaining() const { return reader_.remaining(); }
  [[nodiscard]] std::endian order() const { return reader_.order(); }

  template <class T>
  [[nodiscard]] T read() {
    align(sizeof(T));
    return reader_.read<T>();
  }
  template <class T>
  void skip(std::size_t count = 1) {
    align(sizeof(T));
    reader_.skip(std::uint64_t{count} * sizeof(T));
  }
  [[nodiscard]] std::span<const std::byte> take(std::uint64_t count) { return reader_.take(count); }

  /// A string without the zero byte that CDR counts as part of it.
  [[nodiscard]] std::string_view read_string() {
    align(sizeof(std::uint32_t));
    std::string_view text = reader_.read_string();
    if (wire_ == RosWire::kCdr && text.ends_with('\0')) text.remove_suffix(1);
    return text;
  }

  /// CDR pads to the size of the next value, counted from the end of the encapsulation header.
  void align(std::size_t bytes) {
    if (wire_ == RosWire::kCdr) reader_.skip((bytes - reader_.position() % bytes) % bytes);
  }

 private:
  static constexpr std::size_t kEncapsulationBytes = 4;

  [[nodiscard]] static bool is_plain_cdr(std::span<const std::byte> message) {
    return message.size() >= kEncapsulationBytes && message[0] == std::byte{0} &&
           message[1] <= std::byte{1};
  }
  [[nodiscard]] static std::span<const std::byte> body_of(std::span<const std::byte> message,
                                                          RosWire wire) {
    if (wire == RosWire::kRos1) return message;
    return message.subspan(std::min(message.size(), kEncapsulationBytes));
  }
  [[nodiscard]] static std::endian order_of(std::span<const std::byte> message, RosWire wire) {
    const bool big = wire == RosWire::kCdr && message.size() > 1 && message[1] == std::byte{0};
    return big ? std::endian::big : std::endian::little;
  }

  RosWire wire_;
  ByteReader reader_;
};

}  // namespace hybridfusion
