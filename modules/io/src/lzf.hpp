#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

/// Unpacks LZF data (the format of Marc Lehmann's liblzf, which PCD uses) of exactly
/// `unpacked_bytes`; nothing when the data contradict that. The caller bounds `unpacked_bytes`.
[[nodiscard]] std::optional<std::vector<std::byte>> lzf_unpack(std::span<const std::byte> packed,
                                                               std::size_t unpacked_bytes);

/// Packs by greedy search for repeats within the last 8 KiB.
[[nodiscard]] std::string lzf_pack(std::string_view bytes);

/// No LZF data of one byte unpack to more than this.
inline constexpr std::size_t kMaxLzfRatio = 264;

}  // namespace hybridfusion
