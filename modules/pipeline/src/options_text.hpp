#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// One group of the options as YAML text, every value spelled out.
[[nodiscard]] std::string options_text(const PipelineOptions& options, std::string_view group);

/// Puts the named groups into config.yaml of the workspace; groups of stages that ran before stay.
[[nodiscard]] Expected<void> save_effective_options(const Project& project,
                                                    const std::vector<std::string_view>& groups);

}  // namespace hybridfusion
