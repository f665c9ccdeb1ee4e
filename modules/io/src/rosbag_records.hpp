#pragma once

#include <hybridfusion/core/time.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Record kinds of the ROS bag format 2.0 (wiki.ros.org/Bags/Format/2.0).
enum class BagOp : std::uint8_t {
  kMessage = 0x02,
  kBagHeader = 0x03,
  kIndexData = 0x04,
  kChunk = 0x05,
  kChunkInfo = 0x06,
  kConnection = 0x07
};

/// The "name=value" fields of a record header. Views into the bytes it was parsed from.
class BagFields {
 public:
  /// Nothing when the lengths do not add up.
  [[nodiscard]] static std::optional<BagFields> parse(std::span<const std::byte> header);

  [[nodiscard]] std::optional<std::string_view> text(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint8_t> u8(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint32_t> u32(std::string_view name) const;
  [[nodiscard]] std::optional<std::uint64_t> u64(std::string_view name) const;
  /// Two 32-bit numbers: seconds and nanoseconds.
  [[nodiscard]] std::optional<Timestamp> time(std::string_view name) const;
  [[nodiscard]] std::optional<BagOp> op() const;

 private:
  struct Entry {
    std::string_view name;
    std::string_view value;
  };
  std::vector<Entry> entries_ = {};
};

struct Decompressed {
  std::vector<std::byte> bytes = {};
  std::string problem = {};  ///< Why the bytes are not all there; empty when they are.
};

/// Unpacks chunk data: "none", "bz2", "lz4" or (MCAP) "zstd". What precedes damage or the end of
/// the input is kept.
/// @param declared_bytes  Size that the chunk announces; never exceeded.
[[nodiscard]] Decompressed decompress_chunk(std::string_view compression,
                                            std::span<const std::byte> packed,
                                            std::uint64_t declared_bytes);

}  // namespace hybridfusion
