#pragma once

#include <hybridfusion/viewer/viewer_server.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace hybridfusion {

/// Content that is ready to be read: an open file or bytes in memory.
class OpenContent {
 public:
  /// @returns kNotFound for a file that is missing, not regular or outside of `root`.
  [[nodiscard]] static Expected<OpenContent> open(const std::filesystem::path& root,
                                                  const ServedFile& file);
  OpenContent(OpenContent&& other) noexcept;
  OpenContent& operator=(OpenContent&& other) noexcept;
  OpenContent(const OpenContent&) = delete;
  OpenContent& operator=(const OpenContent&) = delete;
  ~OpenContent();

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Reads up to `buffer.size()` bytes at `offset`. @returns how many; 0 when the file has shrunk.
  [[nodiscard]] std::size_t read(std::uint64_t offset, std::span<char> buffer) const;

 private:
  OpenContent() = default;

  int descriptor_ = -1;
  std::string_view bytes_ = {};
  std::uint64_t size_ = 0;
};

/// Bytes first..last of a file, both included.
struct ByteRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// The one range of a Range header ("bytes=0-99", "bytes=100-", "bytes=-100") within `size` bytes.
/// Several ranges, another unit or a range that lies outside give nothing.
[[nodiscard]] std::optional<ByteRange> parse_range(std::string_view header, std::uint64_t size);

}  // namespace hybridfusion
