#include "drive_kinds.hpp"

namespace hybridfusion::benchmark {
namespace {

/// Two small blocks, a figure-eight of about 260 m in 64 s; only the recording is made.
SimulationOptions figure_eight() {
  SimulationOptions options;
  options.flight.enabled = false;
  options.samples_per_m2 = 0.1;
  options.world.size_m = 60.0;
  options.world.blocks_x = 2;
  options.world.ambient_rays = 4;
  options.drive.route = "figure-eight";
  options.drive.duration_s = 64.0;
  options.lidar.columns = 2100;  // about 55 000 returns of 32 lines
  return options;
}

SimulationOptions aggressive() {
  SimulationOptions options = figure_eight();
  options.drive.swing_deg = 20.0;
  return options;
}

SimulationOptions sixteen_lines() {
  SimulationOptions options = figure_eight();
  options.lidar.beams = 16;
  options.lidar.lowest_deg = -15.0;
  options.lidar.highest_deg = 15.0;
  options.lidar.columns = 1800;
  return options;
}

SimulationOptions avia() {
  SimulationOptions options = figure_eight();
  options.lidar.model = "avia";
  options.lidar.avia_rays = 24000;
  options.lidar.message = "pointcloud2";
  return options;
}

SimulationOptions tunnel() {
  SimulationOptions options = sixteen_lines();
  options.drive.route = "loop";
  options.world.variant = "tunnel";
  options.world.blocks_x = 1;
  options.world.size_m = 200.0;  // four fifths of it are driven
  options.drive.duration_s = 40.0;
  return options;
}

/// Ten minutes and some ten laps around one small block: what still grows on known ground is a
/// leak.
SimulationOptions ten_minutes() {
  SimulationOptions options = sixteen_lines();
  options.world.blocks_x = 1;
  options.world.size_m = 50.0;
  options.lidar.columns = 600;
  options.drive.route = "loop";
  options.drive.loop_overlap_m = 1000.0;
  options.drive.duration_s = 600.0;
  return options;
}

}  // namespace

const std::vector<DriveKind>& drive_kinds() {
  static const std::vector<DriveKind> kinds = {
      {.name = "32-lines",
       .text = "32 lines, figure-eight",
       .goals = {.filter_ate_m = 0.006, .offline_ate_m = 0.004, .startup_m = 0.03},
       .fast_lio = {.ate_m = 0.0073, .cpu_ms_median = 57, .cpu_ms_p95 = 94, .memory_mib = 213},
       .simulation = figure_eight()},
      {.name = "aggressive",
       .text = "the same, roll and pitch +-20 deg",
       .goals = {.filter_ate_m = 0.008, .offline_ate_m = 0.005, .startup_m = 0.05},
       .fast_lio = {.ate_m = 0.011, .cpu_ms_median = 65, .cpu_ms_p95 = 89, .memory_mib = 227},
       .simulation = aggressive()},
      {.name = "16-lines",
       .text = "16 lines, figure-eight",
       .goals = {.filter_ate_m = 0.015, .offline_ate_m = 0.006, .startup_m = 0.06},
       .fast_lio = {.ate_m = 0.0406, .cpu_ms_median = 40, .cpu_ms_p95 = 59, .memory_mib = 215},
       .simulation = sixteen_lines()},
      {.name = "avia",
       .text = "Livox-Avia-like rosette, figure-eight",
       .goals = {.filter_ate_m = 0.08, .offline_ate_m = 0.06},
       .fast_lio = {.ate_m = 0.246, .cpu_ms_median = 32, .cpu_ms_p95 = 50, .memory_mib = 202},
       .simulation = avia()},
      {.name = "tunnel",
       .text = "tunnel, 16 lines, 160 m straight",
       .goals = {.filter_ate_m = 0.06, .offline_ate_m = 0.04},
       .fast_lio = {.ate_m = 0.078, .cpu_ms_median = 11, .cpu_ms_p95 = 13, .memory_mib = 174},
       .simulation = tunnel()},
      {.name = "long",
       .text = "16 lines of 600 rays, ten minutes, several laps: memory over time; on request",
       .unasked = false,
       .simulation = ten_minutes()}};
  return kinds;
}

std::vector<Variant> variants() {
  std::vector<Variant> out;
  const OdometryOptions defaults;
  // The names come from the option's own table; without such an option there is one map.
  std::string_view choices = "hash";
  visit_fields(defaults.local_map, [&](const FieldInfo& info, const auto&) {
    if (info.key == "structure") choices = info.choices;
  });
  while (!choices.empty()) {
    const std::string name(choices.substr(0, choices.find('|')));
    choices.remove_prefix(std::min(choices.size(), name.size() + 1));
    OdometryOptions options;
    if (set_option(options, "local_map.structure", name) || out.empty()) {
      out.push_back({.name = name, .options = options});
    }
  }
  out.push_back({.name = "offline", .offline = true});
  return out;
}

}  // namespace hybridfusion::benchmark
