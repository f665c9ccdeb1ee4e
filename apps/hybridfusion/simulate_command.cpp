#include "cli.hpp"

#include <hybridfusion/simulation/simulate.hpp>

#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hybridfusion::cli {
namespace {

struct SimulateArguments {
  std::string output = {};
  std::string preset = "small";
  std::optional<int> building = {};
  std::string variant = {};
  std::string lidar = {};
  std::string world = {};
};

/// The preset, then the command's own flags, then every --set simulation.KEY=VALUE.
Expected<SimulationOptions> effective_options(const SimulateArguments& arguments,
                                              const std::vector<std::string>& settings) {
  auto options = simulation_preset(arguments.preset);
  if (!options) return options;
  if (arguments.building) options->world.main_building = *arguments.building;
  if (!arguments.variant.empty()) options->world.variant = arguments.variant;
  if (!arguments.lidar.empty()) options->lidar.model = arguments.lidar;
  if (!arguments.world.empty()) options->world.mesh = arguments.world;
  for (const std::string& setting : settings) {
    if (!setting.starts_with(kSimulationPrefix)) continue;
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      return fail(ErrorCode::kInvalidOptions,
                  fmt::format("--set {}: expected simulation.key=value", setting));
    }
    const std::string_view key =
        std::string_view(setting).substr(0, equals).substr(kSimulationPrefix.size());
    auto set = set_option(*options,
                          key,
                          std::string_view(setting).substr(equals + 1),
                          std::string(kSimulationPrefix.substr(0, kSimulationPrefix.size() - 1)));
    if (!set) return std::unexpected(set.error());
  }
  return options;
}

nlohmann::ordered_json summary_json(const std::string& folder, const SimulationSummary& summary) {
  return {{"output", folder},
          {"photos", summary.photos},
          {"drives", summary.drives},
          {"path_m", summary.path_m},
          {"scans", summary.scans},
          {"lidar_points", summary.lidar_points},
          {"imu_samples", summary.imu_samples},
          {"gnss_fixes", summary.gnss_fixes},
          {"street_images", summary.street_images},
          {"triangles", summary.triangles},
          {"truth_samples", summary.truth_samples}};
}

/// One data set, or with the preset `paper` and no building the four of Table I.
int simulate_all(const SimulateArguments& arguments, Session& session) {
  auto options = effective_options(arguments, session.globals.settings);
  if (!options) return report_error(session, options.error());
  std::vector<std::pair<std::string, int>> scenes;
  if (arguments.preset == "paper" && !arguments.building) {
    for (int building = 1; building <= 4; ++building) {
      const std::filesystem::path folder =
          std::filesystem::path(arguments.output) / fmt::format("sim-building{}", building);
      scenes.emplace_back(folder.string(), building);
    }
  } else {
    scenes.emplace_back(arguments.output, options->world.main_building);
  }
  nlohmann::ordered_json done = nlohmann::ordered_json::array();
  for (const auto& [folder, building] : scenes) {
    options->world.main_building = building;
    const auto summary = simulate(folder, *options, session.context);
    if (!summary) {
      // What is in the way of the output is a matter of the command line, not of the disk.
      const int code = report_error(session, summary.error());
      return code == kOutOfResource && std::filesystem::exists(folder) ? kUsage : code;
    }
    done.push_back(summary_json(folder, *summary));
    if (!session.globals.json) {
      fmt::print("{}: {} photos, {} scans with {} points over {:.0f} m, {} truth samples\n",
                 folder,
                 summary->photos,
                 summary->scans,
                 summary->lidar_points,
                 summary->path_m,
                 summary->truth_samples);
    }
  }
  if (session.globals.json) {
    const nlohmann::ordered_json json = {
        {"status", "ok"}, {"exit_code", 0}, {"preset", arguments.preset}, {"data_sets", done}};
    fmt::print("{}\n", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return kDone;
}

}  // namespace

std::string simulation_reference() {
  std::string markdown;
  append_reference(markdown,
                   SimulationOptions{},
                   std::string(kSimulationPrefix.substr(0, kSimulationPrefix.size() - 1)));
  return markdown;
}

void add_simulate_command(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "simulate",
      "Makes a cross-view data set with exact truth: drone photos, a street LiDAR/IMU/GNSS "
      "recording and truth/, from --seed.");
  auto arguments = std::make_shared<SimulateArguments>();
  command->add_option("--output", arguments->output, "Folder to make; refused when it holds files")
      ->required();
  command
      ->add_option("--preset",
                   arguments->preset,
                   "small (24 photos, 60 m block, 40 s drive); paper (sim-building1..4, 29 "
                   "photos 1600x1200 each); city (5 x 4 blocks, several drives)")
      ->check(CLI::IsMember({"small", "paper", "city"}))
      ->capture_default_str();
  command->add_option("--building", arguments->building, "paper: only this building")
      ->check(CLI::Range(1, 4));
  command
      ->add_option("--variant",
                   arguments->variant,
                   "town, dull, repetitive, flat (a field) or other-site (flight and drive at "
                   "two places)")
      ->check(CLI::IsMember({"town", "dull", "repetitive", "flat", "other-site"}));
  command->add_option("--lidar", arguments->lidar, "spinning or avia")
      ->check(CLI::IsMember({"spinning", "avia"}));
  command->add_option("--world", arguments->world, "PLY mesh to use instead of a generated block");
  command->footer(
      help_footer("hybridfusion simulate --output data/ --preset small --seed 7 --set "
                  "simulation.gnss.rtk=true",
                  "the mesh of --world, if given",
                  "OUTPUT/images/*.jpg, street.bag, sensors.yaml, truth/"));
  command->callback([arguments, &chosen] {
    chosen = [arguments](Session& session) { return simulate_all(*arguments, session); };
  });
}

}  // namespace hybridfusion::cli
