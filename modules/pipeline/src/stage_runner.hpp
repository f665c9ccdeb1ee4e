#pragma once

#include <hybridfusion/pipeline/stages.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace hybridfusion {

/// What decides whether a stage must run, and what it leaves behind.
struct StagePlan {
  std::string_view stage = {};
  std::vector<std::string_view> option_groups = {};  ///< Groups of PipelineOptions it depends on.
  std::vector<std::filesystem::path> inputs = {};    ///< In a fixed order.
  std::vector<std::string_view> outputs = {};        ///< All files it may write.
  std::string_view variant = {};                     ///< What else the result depends on.
};

/// Result of the body of a stage.
struct StageResult {
  bool refused = false;
  std::string json = "{}";
  std::vector<std::string> summary = {};
};

/// Runs `body` unless the last run is still good. Outputs of an outdated run are deleted first, so
/// that a failure never leaves results that do not belong together.
[[nodiscard]] Expected<StageOutcome> run_stage(Project& project,
                                               const StagePlan& plan,
                                               const RunContext& ctx,
                                               const std::function<Expected<StageResult>()>& body);

}  // namespace hybridfusion
