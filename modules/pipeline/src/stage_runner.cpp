#include "stage_runner.hpp"

#include "digest.hpp"
#include "options_text.hpp"
#include "run_record.hpp"
#include "stage_meter.hpp"

#include <hybridfusion/core/parallel.hpp>

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion {
namespace {

using Json = nlohmann::ordered_json;

std::string key_of(const StagePlan& plan,
                   const PipelineOptions& options,
                   const std::vector<FileRecord>& inputs,
                   std::uint64_t seed) {
  std::string text =
      fmt::format("{} {} {} seed {}\n", program_version(), plan.stage, plan.variant, seed);
  for (const std::string_view group : plan.option_groups) text += options_text(options, group);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    text += fmt::format("{} {}\n", plan.inputs[i].filename().string(), inputs[i].sha256);
  }
  return sha256_of(text);
}

bool outputs_stand(const StageRecord& record, const Workspace& workspace) {
  return std::ranges::all_of(record.outputs, [&](const FileRecord& output) {
    return is_unchanged(output, workspace.path(output.path));
  });
}

/// A result of the former run, as stored by store().
StageOutcome former_outcome(const StagePlan& plan, const StageRecord& record) {
  const Json json = Json::parse(record.result_json);
  StageOutcome outcome{.stage = std::string(plan.stage), .up_to_date = true, .cost = record.cost};
  outcome.refused = json.value("refused", false);
  outcome.summary = json.value("summary", std::vector<std::string>{});
  outcome.result_json = json.value("result", Json::object()).dump();
  return outcome;
}

Expected<std::vector<FileRecord>> describe_outputs(const StagePlan& plan,
                                                   const Workspace& workspace,
                                                   const RunRecord& record) {
  std::vector<FileRecord> outputs;
  for (const std::string_view name : plan.outputs) {
    if (!workspace.has(name)) continue;
    const std::filesystem::path path = workspace.path(name);
    HF_TRY(std::vector<FileRecord> files, describe_files({&path, 1}, record));
    files.front().path = name;
    outputs.push_back(std::move(files.front()));
  }
  return outputs;
}

}  // namespace

Expected<StageOutcome> run_stage(Project& project,
                                 const StagePlan& plan,
                                 const RunContext& ctx,
                                 const std::function<Expected<StageResult>()>& body) {
  const std::filesystem::path run_path = project.workspace.path(workspace_file::kRun);
  RunRecord record = RunRecord::load(run_path);
  const std::string stage(plan.stage);
  HF_TRY(const std::vector<FileRecord> inputs, describe_files(plan.inputs, record));
  const std::string key = key_of(plan, project.options, inputs, ctx.seed);
  const auto former = record.stages.find(stage);
  const bool forced = std::ranges::find(project.forced, stage) != project.forced.end();
  if (!forced && former != record.stages.end() && former->second.key == key &&
      outputs_stand(former->second, project.workspace)) {
    ctx.info(fmt::format("{}: up to date", stage));
    return former_outcome(plan, former->second);
  }
  if (former != record.stages.end()) {
    record.stages.erase(former);
    if (auto saved = record.save(run_path); !saved) return std::unexpected(saved.error());
  }
  for (const std::string_view output : plan.outputs) project.workspace.remove(output);
  const StageMeter meter;
  HF_TRY(const StageResult result, body());
  const StageCost cost = meter.cost();
  StageRecord entry{.key = key, .inputs = inputs, .cost = cost, .seed = ctx.seed};
  entry.threads = effective_threads(ctx);
  HF_TRY(entry.outputs, describe_outputs(plan, project.workspace, record));
  const Json stored = {{"refused", result.refused},
                       {"summary", result.summary},
                       {"result", Json::parse(result.json)}};
  entry.result_json = stored.dump(-1, ' ', false, Json::error_handler_t::replace);
  record.stages[stage] = std::move(entry);
  if (auto saved = record.save(run_path); !saved) return std::unexpected(saved.error());
  if (auto saved = save_effective_options(project, plan.option_groups); !saved) {
    return std::unexpected(saved.error());
  }
  return StageOutcome{.stage = stage,
                      .refused = result.refused,
                      .cost = cost,
                      .result_json = result.json,
                      .summary = result.summary};
}

}  // namespace hybridfusion
