#pragma once

#include <cstdint>

namespace hybridfusion {

/// How the bytes of a message are laid out.
enum class RosWire : std::uint8_t {
  kRos1,  ///< Packed, little-endian.
  kCdr,   ///< ROS 2: OMG CDR with its 4-byte encapsulation header, aligned, either byte order.
};

}  // namespace hybridfusion
