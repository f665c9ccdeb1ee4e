#pragma once

#include "input_file.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace hybridfusion {

/// Lines of a text file with their numbers, for messages that name the line.
class TextLines {
 public:
  [[nodiscard]] static Expected<TextLines> open(const std::filesystem::path& path) {
    HF_TRY(InputFile file, InputFile::open(path));
    return TextLines(std::move(file));
  }

  /// The next line; nothing at the end.
  [[nodiscard]] Expected<std::optional<std::string_view>> next() {
    ++number_;
    return file_.line();
  }

  [[nodiscard]] const InputFile& file() const { return file_; }

  [[nodiscard]] std::unexpected<Error> malformed(
      std::string_view cause,
      std::string_view remedy,
      std::source_location where = std::source_location::current()) const {
    return file_.malformed(fmt::format("line {}: {}", number_, cause), remedy, where);
  }

 private:
  explicit TextLines(InputFile file) : file_(std::move(file)) {}
  InputFile file_;
  std::size_t number_ = 0;
};

}  // namespace hybridfusion
