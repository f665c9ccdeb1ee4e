#pragma once

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace hybridfusion {

/// Bytes put aside for later. With a folder they lie in a file there that has no name (nothing is
/// left behind, whatever happens) and take no memory; without one they stay in memory.
class SpillFile {
 public:
  struct Block {
    std::uint64_t at = 0;
    std::uint32_t size = 0;  ///< [bytes]
  };

  SpillFile() = default;
  /// @returns kIo naming the folder and the system's reason.
  [[nodiscard]] static Expected<SpillFile> create(const std::filesystem::path& folder);
  SpillFile(SpillFile&& other) noexcept;
  SpillFile& operator=(SpillFile&& other) noexcept;
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;
  ~SpillFile();

  /// @returns kIo, e.g. when the disk is full.
  [[nodiscard]] Expected<Block> append(std::span<const std::byte> bytes);
  /// Fills `out`, which becomes as long as the block. May run on several threads at once.
  [[nodiscard]] Expected<void> read(const Block& block, std::vector<std::byte>& out) const;
  /// Gives the room of a block back; it cannot be read any more.
  void drop(const Block& block);
  /// An empty one in the same folder, or in memory. @returns kIo.
  [[nodiscard]] Expected<SpillFile> another() const;

 private:
  [[nodiscard]] bool in_memory() const { return descriptor_ < 0; }
  void close() noexcept;

  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::filesystem::path folder_ = {};
  std::vector<std::vector<std::byte>> blocks_ = {};
};

}  // namespace hybridfusion
