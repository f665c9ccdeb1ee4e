#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace hybridfusion {

struct PipelineOptions;

/// Overwrites what the YAML file names and checks every range.
/// @returns kNotFound for a missing file; kParse or kInvalidOptions with file and line.
[[nodiscard]] Expected<void> load_options(const std::filesystem::path& path,
                                          PipelineOptions& options);

/// Applies one "group.option=value" and checks every range. @returns kInvalidOptions.
[[nodiscard]] Expected<void> apply_setting(std::string_view setting, PipelineOptions& options);

/// The options as YAML that load_options reads back.
[[nodiscard]] std::string to_yaml(const PipelineOptions& options);

/// The same as one JSON object, which to_yaml's readers read, too.
[[nodiscard]] std::string to_json(const PipelineOptions& options);

/// Reference table of every option in Markdown: default, unit, range, meaning, source.
[[nodiscard]] std::string options_reference();

}  // namespace hybridfusion
