#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/run_context.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace hybridfusion {

/// A temporary file that has a name only while a reader opens it: its blocks are free again when
/// the last reader closes, however the program ends.
class ScratchFile {
 public:
  /// @param folder  Where its blocks lie. @returns kIo naming folder and reason.
  [[nodiscard]] static Expected<ScratchFile> create(const std::filesystem::path& folder);

  ScratchFile(ScratchFile&& other) noexcept;
  ScratchFile& operator=(ScratchFile&& other) noexcept;
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  /// Gives it a name in its folder, for a reader to open; drop_name() follows at once.
  [[nodiscard]] Expected<std::filesystem::path> give_name();
  void drop_name();
  [[nodiscard]] std::uint64_t size() const { return written_; }
  /// @returns kIo naming the folder, the bytes written so far and the reason (e.g. disk full).
  [[nodiscard]] Expected<void> write(std::span<const std::byte> bytes);

 private:
  ScratchFile(std::filesystem::path folder, int descriptor, std::string name)
      : folder_(std::move(folder)), descriptor_(descriptor), name_(std::move(name)) {}

  std::filesystem::path folder_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;
  std::string name_ = {};  ///< Empty most of the time.
};

/// Unpacked file, and why it is not complete (empty: it is).
struct UnpackedFile {
  ScratchFile file;
  std::string problem = {};
};

/// Unpacks a zstd file in pieces. What precedes damage or the end of a cut file is kept.
/// @param folder  Where the unpacked bytes lie.
/// @returns kNotFound, kIo (disk full), kParse when nothing could be unpacked, kCancelled.
[[nodiscard]] Expected<UnpackedFile> unpack_zstd_file(const std::filesystem::path& path,
                                                      const std::filesystem::path& folder,
                                                      const RunContext& ctx);

}  // namespace hybridfusion
