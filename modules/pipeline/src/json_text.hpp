#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace hybridfusion {

using Json = nlohmann::ordered_json;

/// Indented text; bytes that are not UTF-8 (odd file names) become the replacement character.
[[nodiscard]] inline std::string to_text(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Row-major 4x4.
template <class Transform>
[[nodiscard]] Json matrix_json(const Transform& target_from_source) {
  const Eigen::Matrix4d matrix = target_from_source.matrix();
  Json numbers = Json::array();
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) numbers.push_back(matrix(r, c));
  }
  return numbers;
}

/// @returns kNotFound, or kParse naming the file.
[[nodiscard]] Expected<Json> read_json(const std::filesystem::path& path);

/// @throws Json::exception when it is not an array of 16 numbers.
[[nodiscard]] Eigen::Matrix4d matrix_of(const Json& numbers);

}  // namespace hybridfusion
