#pragma once

#include <hybridfusion/core/rigid3.hpp>

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace hybridfusion::testing {

using Json = nlohmann::ordered_json;

/// Writes a text file and the folders above it.
void write_text(const std::filesystem::path& path, const std::string& text);

/// The 16 numbers of the matrix, row by row.
Json matrix(const Rigid3& pose);

/// What the stages wrote of an accepted registration with the heading `yaw_rad`: its file, the
/// metrics and the record of the run.
void write_sample_results(const std::filesystem::path& root,
                          const Rigid3& vision_from_lidar,
                          double yaw_rad);

}  // namespace hybridfusion::testing
