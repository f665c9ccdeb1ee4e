#include "cli.hpp"

#include <hybridfusion/pipeline/pipeline_options.hpp>

#include <memory>
#include <numbers>
#include <optional>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct RegisterArguments {
  std::string vision = {};
  std::string lidar = {};
  std::string output = {};
  std::string initial = {};
  std::optional<double> max_offset_m = {};
  std::optional<double> max_yaw_deg = {};
  std::string method = {};
};

int register_clouds(const RegisterArguments& arguments, Session& session) {
  RegistrationOptions& options = session.options.registration;
  if (!arguments.method.empty()) options.method = arguments.method;
  if (arguments.max_offset_m) options.max_offset_m = *arguments.max_offset_m;
  if (arguments.max_yaw_deg)
    options.max_yaw_rad = *arguments.max_yaw_deg * std::numbers::pi / 180.0;
  RegisterInputs inputs{.vision = arguments.vision, .lidar = arguments.lidar};
  if (!arguments.initial.empty()) inputs.initial = arguments.initial;
  // Unknown heading alone says that there is no coarse pose: then no offset limit holds either.
  const bool heading_limited = arguments.max_yaw_deg && *arguments.max_yaw_deg < 180.0;
  inputs.near_identity = arguments.max_offset_m || heading_limited;
  return run_stages(session, arguments.output, {}, {[&](Project& project) {
                      return register_stage(project, inputs, session.context);
                    }});
}

}  // namespace

void add_register_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "register",
      "Module C: vision cloud and LiDAR cloud -> transform and fused cloud. Writes "
      "OUTPUT/registration/registration.json and OUTPUT/fused/fused.ply, fused.las. Without "
      "--initial and --max-offset-m the whole overlap is searched; without --max-yaw-deg, too, "
      "every heading.");
  auto arguments = std::make_shared<RegisterArguments>();
  command->add_option("--vision", arguments->vision, "Vision cloud G (.ply, .pcd, .xyz)")
      ->required();
  command->add_option("--lidar", arguments->lidar, "LiDAR cloud L (.ply, .pcd, .xyz)")->required();
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->add_option("--initial",
                      arguments->initial,
                      "Coarse pose: JSON {\"vision_from_lidar\": [16, row-major]}");
  command
      ->add_option("--max-offset-m",
                   arguments->max_offset_m,
                   "How far the coarse pose (identity without --initial) may be off "
                   "horizontally [m] (default 20)")
      ->check(CLI::Range(0.0, 1e5));
  command
      ->add_option("--max-yaw-deg",
                   arguments->max_yaw_deg,
                   "How far its heading may be off [deg]; 180: unknown (default 30)")
      ->check(CLI::Range(0.0, 180.0));
  command
      ->add_option("--method",
                   arguments->method,
                   "hybrid: ours; paper: the published chain; gicp, ndt: baselines (default "
                   "hybrid)")
      ->check(CLI::IsMember({"hybrid", "paper", "gicp", "ndt"}));
  command->footer(help_footer(
      "hybridfusion register --vision G.ply --lidar L.ply --output result/\n  hybridfusion "
      "register --vision G.ply --lidar L.ply --output result/ --max-yaw-deg 180",
      "VISION, LIDAR: clouds in metres, z up; INITIAL: JSON; beside clouds of a workspace also\n  "
      "origin.json, pose_covariance.csv, gnss.json, level.json and trajectory.tum",
      "OUTPUT/registration/registration.json; unless refused OUTPUT/fused/fused.ply, fused.las;\n  "
      "OUTPUT/config.yaml, run.json, report/index.html"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return register_clouds(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
