#pragma once

#include <hybridfusion/core/error.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// Regular file read forward through one buffer. Every size asked for is checked against what
/// remains of the file before memory is taken.
class InputFile {
 public:
  /// @param name  What messages call the file; empty: its path.
  /// @returns kNotFound for a missing file, kIo for one that cannot be read, kParse when it is
  /// empty or not a regular file.
  [[nodiscard]] static Expected<InputFile> open(const std::filesystem::path& path,
                                                const std::filesystem::path& name = {});

  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Offset of the next byte that take(), line() or token() returns.
  [[nodiscard]] std::uint64_t position() const { return position_; }
  [[nodiscard]] std::uint64_t remaining() const { return size_ - position_; }

  /// The next `count` bytes, valid until the next call. @returns kParse when fewer remain.
  [[nodiscard]] Expected<std::span<const std::byte>> take(std::uint64_t count);
  /// The next line without its end; nothing at the end of the file. kParse above 64 MiB.
  [[nodiscard]] Expected<std::optional<std::string_view>> line();
  /// The next run of characters that are not white space; nothing at the end of the file.
  [[nodiscard]] Expected<std::optional<std::string_view>> token();
  [[nodiscard]] Expected<void> skip(std::uint64_t count);
  void seek(std::uint64_t position);

  /// kParse with "<path>: <cause>; <remedy>".
  [[nodiscard]] std::unexpected<Error> malformed(
      std::string_view cause,
      std::string_view remedy = "check that the file is complete",
      std::source_location where = std::source_location::current()) const;

 private:
  InputFile(std::filesystem::path path, int descriptor, std::uint64_t size);
  [[nodiscard]] Expected<bool> is_lfs_pointer();
  /// Makes at least `count` bytes available in the buffer (fewer only at the end of the file).
  [[nodiscard]] Expected<std::span<const std::byte>> fill(std::size_t count);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::vector<std::byte> buffer_ = {};
  std::size_t begin_ = 0;  ///< Of the unread part of the buffer.
  std::size_t end_ = 0;
};

}  // namespace hybridfusion
