#include "cli.hpp"

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

namespace hybridfusion::cli {
namespace {

struct MapArguments {
  std::string bag = {};
  std::string output = {};
  std::string sensors = {};
  bool calibrate = false;
};

}  // namespace

void add_map_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "map",
      "Module B: LiDAR + IMU (+ GNSS) recording -> trajectory and map. Writes OUTPUT/lidar: "
      "trajectory.tum, map.ply, quality.csv, level.json and, with GNSS, gnss.json.");
  auto arguments = std::make_shared<MapArguments>();
  command->add_option("--bag", arguments->bag, kRecordingHelp)->required();
  command->add_option("--output", arguments->output, "Workspace folder")->required();
  command->add_option(
      "--sensors", arguments->sensors, "sensors.yaml (default: the one beside the bag)");
  command->add_flag("--calibrate",
                    arguments->calibrate,
                    "Do not map: find imu_from_lidar and the time offset from a drive with curves "
                    "and changes of speed, write them to OUTPUT/lidar/sensors.yaml");
  command->footer(
      help_footer("hybridfusion map --bag street.bag --output result/",
                  "BAG: PointCloud2 or Livox CustomMsg, Imu, NavSatFix; sensors.yaml",
                  "OUTPUT/lidar/trajectory.tum, map.ply, quality.csv, level.json, gnss.json (with "
                  "GNSS);\n  OUTPUT/config.yaml, run.json, report/index.html"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) {
      std::optional<std::filesystem::path> sensors;
      if (!arguments->sensors.empty()) sensors = arguments->sensors;
      return run_stages(session, arguments->output, {}, {[&](Project& project) {
                          const auto stage = arguments->calibrate ? calibrate_stage : map_stage;
                          return stage(project, arguments->bag, sensors, session.context);
                        }});
    };
  });
}

}  // namespace hybridfusion::cli
