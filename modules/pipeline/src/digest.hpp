#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace hybridfusion {

/// Lower-case hexadecimal SHA-256.
[[nodiscard]] std::string sha256_of(std::string_view bytes);

/// SHA-256 of a file's content, read in pieces. @returns kNotFound when it cannot be opened, kParse
/// when reading stops early.
[[nodiscard]] Expected<std::string> sha256_of_file(const std::filesystem::path& path);

}  // namespace hybridfusion
