#include "cli.hpp"

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct EvaluateArguments {
  std::string workspace = {};
  std::string truth = {};
  std::string vision = {};
  std::string lidar = {};
  std::string transform = {};
};

int evaluate(const EvaluateArguments& arguments, Session& session) {
  if (!arguments.workspace.empty()) {
    if (!std::filesystem::is_directory(arguments.workspace)) {
      return report_error(
          session,
          {.code = ErrorCode::kNotFound,
           .message = arguments.workspace + ": there is no such workspace; check --workspace"});
    }
    return run_stages(session, arguments.workspace, {}, {[&](Project& project) {
                        return evaluate_stage(
                            project, optional_path(arguments.truth), session.context);
                      }});
  }
  const auto outcome = evaluate_pair({.vision = arguments.vision,
                                      .lidar = arguments.lidar,
                                      .transform = optional_path(arguments.transform),
                                      .truth = optional_path(arguments.truth)},
                                     session.options,
                                     session.context);
  if (!outcome) return report_error(session, outcome.error());
  print_outcome(session, *outcome);
  return kDone;
}

}  // namespace

void add_evaluate_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "evaluate",
      "The paper's metrics, baselines and, with truth, errors: of a workspace (writes "
      "WS/evaluation/metrics.json), or of two clouds and a transform (writes nothing).");
  auto arguments = std::make_shared<EvaluateArguments>();
  auto* workspace = command->add_option("--workspace", arguments->workspace, "Workspace folder");
  command->add_option("--truth",
                      arguments->truth,
                      "Truth folder of a data set; for two clouds a JSON file with the true "
                      "vision_from_lidar");
  auto* vision = command->add_option("--vision", arguments->vision, "Vision cloud G");
  auto* lidar = command->add_option("--lidar", arguments->lidar, "LiDAR cloud L");
  auto* transform = command->add_option(
      "--transform", arguments->transform, "JSON with vision_from_lidar (default: identity)");
  vision->needs(lidar)->excludes(workspace);
  lidar->needs(vision)->excludes(workspace);
  transform->needs(vision);
  command->footer(help_footer(
      "hybridfusion evaluate --workspace result/ --truth dataset/truth/\n"
      "  hybridfusion evaluate --vision G.ply --lidar L.ply --transform T.json",
      "WORKSPACE and --truth (dataset.json, cameras.csv, trajectory_imu.tum, mesh.ply,\n  "
      "samples.ply, as far as they exist); or two clouds and a transform",
      "WORKSPACE/evaluation/metrics.json, report/index.html, run.json; nothing for two clouds"));
  command->callback([arguments, &chosen] {
    if (arguments->workspace.empty() && arguments->vision.empty()) {
      throw CLI::RequiredError("--workspace, or --vision and --lidar");
    }
    chosen = [arguments](Session& session) { return evaluate(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
