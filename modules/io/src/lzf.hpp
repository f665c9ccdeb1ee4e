#pragma once

#include "input_file.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hybridfusion {

/// Unpacks LZF data (the format of Marc Lehmann's liblzf, which PCD uses) piece by piece. Holds no
/// more than the pieces asked for and the 8 KiB that repeats may reach back.
class LzfReader {
 public:
  /// @param file  Positioned at the first packed byte. @pre packed_bytes <= file.remaining()
  LzfReader(InputFile file, std::uint64_t packed_bytes)
      : file_(std::move(file)), packed_left_(packed_bytes) {}

  /// The next `count` unpacked bytes, valid until the next call. @returns kParse when the data are
  /// damaged or end before.
  [[nodiscard]] Expected<std::span<const std::byte>> take(std::size_t count);
  [[nodiscard]] Expected<void> skip(std::uint64_t count);
  /// True when nothing is left to unpack.
  [[nodiscard]] bool at_end() const { return packed_left_ == 0 && next_ == out_.size(); }

 private:
  [[nodiscard]] Expected<std::size_t> packed_byte();
  [[nodiscard]] Expected<void> unpack_once();
  [[nodiscard]] std::unexpected<Error> damaged() const;

  InputFile file_;
  std::uint64_t packed_left_ = 0;
  std::vector<std::byte> out_ = {};  ///< What repeats may reach, then what was not taken yet.
  std::size_t next_ = 0;             ///< First byte of out_ that was not taken.
};

/// Packs by greedy search for repeats within the last 8 KiB.
[[nodiscard]] std::string lzf_pack(std::string_view bytes);

/// No LZF data of one byte unpack to more than this.
inline constexpr std::size_t kMaxLzfRatio = 264;

}  // namespace hybridfusion
