#pragma once

#include "byte_reader.hpp"

#include <hybridfusion/core/time.hpp>

#include <algorithm>

namespace hybridfusion {

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};
inline constexpr std::uint64_t kMcapHeaderBytes = 9;
/// Nobody records messages or chunks of more than 1 GiB.
inline constexpr std::uint64_t kMaxMcapRecordBytes = std::uint64_t{1} << 30;

/// Record kinds of MCAP version 0 (mcap.dev/spec) that are read.
enum class McapOp : std::uint8_t {
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kDataEnd = 0x0f
};

struct McapHeader {
  McapOp op = McapOp::kFooter;
  std::uint64_t content_bytes = 0;
};

/// @pre bytes.size() >= kMcapHeaderBytes
[[nodiscard]] inline McapHeader mcap_header(std::span<const std::byte> bytes) {
  return {.op = static_cast<McapOp>(bytes[0]),
          .content_bytes = load<std::uint64_t>(bytes.data() + 1)};
}

[[nodiscard]] inline Timestamp mcap_time(std::uint64_t ns) {
  constexpr std::uint64_t kMax = std::uint64_t{1} << 62;
  return Timestamp(static_cast<std::int64_t>(std::min(ns, kMax)));
}

}  // namespace hybridfusion
