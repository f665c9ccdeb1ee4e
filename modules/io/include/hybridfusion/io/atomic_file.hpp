#pragma once

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// A file that appears under its name only when it is complete: bytes go to "<name>.part" in the
/// same folder; commit() flushes them to the disk and renames. Destroyed without commit(), it
/// leaves nothing behind.
class AtomicFile {
 public:
  /// @returns kIo naming the path and the system's reason when the folder cannot be written.
  [[nodiscard]] static Expected<AtomicFile> create(const std::filesystem::path& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Appends. The first failure is kept and returned by commit(), so that writers need not check
  /// each call.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Replaces the first bytes by as many others. @pre at least that much was written.
  void overwrite_start(std::string_view text);

  /// Makes the file visible. @returns kIo with path, bytes written and reason (e.g. disk full).
  [[nodiscard]] Expected<void> commit();

 private:
  explicit AtomicFile(std::filesystem::path path, int descriptor);
  void flush();
  void discard() noexcept;

  std::filesystem::path path_ = {};
  int descriptor_ = -1;
  int error_number_ = 0;
  std::uint64_t written_ = 0;
  std::vector<std::byte> buffer_ = {};
};

/// Writes the whole content through an AtomicFile.
[[nodiscard]] Expected<void> write_file_atomically(const std::filesystem::path& path,
                                                   std::string_view bytes);

/// The whole file. @returns kNotFound for a missing file, kParse when it is larger than
/// `max_bytes`.
[[nodiscard]] Expected<std::string> read_text_file(const std::filesystem::path& path,
                                                   std::uint64_t max_bytes);

}  // namespace hybridfusion
