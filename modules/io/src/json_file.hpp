#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <filesystem>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

namespace hybridfusion {

/// Parses a JSON object from a file of at most 64 MiB. @returns kNotFound, kParse naming the file.
[[nodiscard]] Expected<nlohmann::json> read_json_object(const std::filesystem::path& path);

/// A finite number member; nothing when absent or of another type.
[[nodiscard]] std::optional<double> json_number(const nlohmann::json& object, std::string_view key);

/// 16 numbers, row-major, of a rigid motion. @returns kNotFound without the key, kParse otherwise.
[[nodiscard]] Expected<Rigid3> json_rigid(const std::filesystem::path& path,
                                          const nlohmann::json& object,
                                          std::string_view key);

}  // namespace hybridfusion
