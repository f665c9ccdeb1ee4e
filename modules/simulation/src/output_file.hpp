#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <fstream>
#include <string_view>

namespace hybridfusion {

/// Sequential output with one check at the end. The whole data set is renamed into place when it is
/// complete, so single files need no such step.
class OutputFile {
 public:
  [[nodiscard]] static Expected<OutputFile> create(const std::filesystem::path& path);

  void write(std::string_view bytes) {
    stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    position_ += bytes.size();
  }
  /// Overwrites bytes at a place already written.
  void rewrite(std::uint64_t offset, std::string_view bytes);
  [[nodiscard]] std::uint64_t position() const { return position_; }
  /// @returns kIo when any write failed.
  [[nodiscard]] Expected<void> close();

 private:
  std::filesystem::path path_ = {};
  std::ofstream stream_ = {};
  std::uint64_t position_ = 0;
};

[[nodiscard]] Expected<void> write_whole_file(const std::filesystem::path& path,
                                              std::string_view bytes);

}  // namespace hybridfusion
