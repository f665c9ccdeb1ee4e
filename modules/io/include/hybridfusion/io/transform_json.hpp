#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/rigid3.hpp>

#include <filesystem>
#include <string_view>

namespace hybridfusion {

/// Reads `{"<key>": [16 numbers, row-major]}`, e.g. key "vision_from_lidar"; other members are
/// ignored.
/// @returns kNotFound for a missing file or key; kParse for anything but a rigid motion (the
/// rotation may be off by rounding only: 1e-3).
[[nodiscard]] Expected<Rigid3> read_transform_json(const std::filesystem::path& path,
                                                   std::string_view key);

/// Writes `{"<key>": [16 numbers]}` so that it reads back to the same bits.
[[nodiscard]] Expected<void> write_transform_json(const std::filesystem::path& path,
                                                  std::string_view key,
                                                  const Rigid3& target_from_source);

}  // namespace hybridfusion
