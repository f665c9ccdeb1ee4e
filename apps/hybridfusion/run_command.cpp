#include "cli.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct RunArguments {
  PhotoArguments photos = {};
  std::string bag = {};
  std::string output = {};
  std::string sensors = {};
  std::string truth = {};
  std::string from = {};
};

/// The stage and all behind it.
std::vector<std::string> stages_from(const std::string& first) {
  if (first.empty()) return {};
  return {std::ranges::find(kStages, first), kStages.end()};
}

int run(const RunArguments& arguments, Session& session) {
  const RunContext& ctx = session.context;
  return run_stages(
      session,
      arguments.output,
      stages_from(arguments.from),
      {[&](Project& project) {
         return reconstruct_stage(project, photo_inputs(arguments.photos), ctx);
       },
       [&](Project& project) {
         return map_stage(project, arguments.bag, optional_path(arguments.sensors), ctx);
       },
       [&](Project& project) {
         return register_stage(project,
                               {.vision = project.workspace.path(workspace_file::kDense),
                                .lidar = project.workspace.path(workspace_file::kMap)},
                               ctx);
       },
       [&](Project& project) {
         return evaluate_stage(project, optional_path(arguments.truth), ctx);
       }});
}

}  // namespace

void add_run_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "run",
      "Photos and a LiDAR/IMU recording -> fused cloud: reconstruct, map, register, evaluate and "
      "report on one workspace. Stages whose inputs and options did not change are not run again.");
  auto arguments = std::make_shared<RunArguments>();
  add_photo_options(*command, arguments->photos);
  command->add_option("--bag", arguments->bag, kRecordingHelp)->required();
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->add_option(
      "--sensors", arguments->sensors, "sensors.yaml (default: the one beside the bag)");
  command->add_option("--truth", arguments->truth, "Truth folder to evaluate against");
  command->add_option("--from", arguments->from, "Run this stage and all behind it again")
      ->check(CLI::IsMember(std::vector<std::string>(kStages.begin(), kStages.end())));
  command->footer(help_footer(
      "hybridfusion run --images flight/ --bag street.bag --output result/",
      "IMAGES: JPEG photos with GNSS; BAG: LiDAR, IMU and GNSS; sensors.yaml; TRUTH, if given",
      "OUTPUT: vision/, lidar/, registration/, fused/fused.ply and fused.las,\n  "
      "evaluation/metrics.json, report/index.html, config.yaml, run.json"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return run(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
