// Recorded drives with a reference trajectory through the installed program, peers beside it. See
// --help.
#include "drive_errors.hpp"
#include "program_run.hpp"
#include "real_drives_table.hpp"

#include <hybridfusion/io/ply.hpp>
#include <hybridfusion/io/sensors_yaml.hpp>
#include <hybridfusion/io/tum.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace {

using namespace hybridfusion;             // NOLINT(google-build-using-namespace): a program
using namespace hybridfusion::benchmark;  // NOLINT(google-build-using-namespace)
namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> folders = {};
  std::string program = {};
  std::string work = {};
  std::string reference = "reference.tum";
  std::vector<std::string> peers = {};
  std::vector<std::string> peer_trajectories = {};
  std::string peer_frame = "lidar";
  double peer_delay_s = 0.0;
  double limit_s = 1800.0;
  bool json = false;
};

std::size_t count_scans(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".pcd") ++count;
  }
  return count;
}

/// "NAME=rest" -> {NAME, rest}.
std::pair<std::string, std::string> split(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  return {text.substr(0, equals), text.substr(std::min(equals + 1, text.size()))};
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

RealDriveRow run_ours(const Arguments& arguments,
                      const fs::path& folder,
                      const Trajectory& reference) {
  const std::string name = folder.filename().string();
  const fs::path output = fs::path(arguments.work) / name;
  fs::remove_all(output);
  RealDriveRow row{.drive = name, .program = "hybridfusion", .num_scans = count_scans(folder)};
  const auto run = run_program(fmt::format("{} map --bag {} --output {} --threads 1",
                                           quoted(arguments.program),
                                           quoted(folder.string()),
                                           quoted(output.string())),
                               fs::path(arguments.work) / (name + ".log"),
                               arguments.limit_s);
  if (run) row.run = *run;
  if (const auto way = read_tum(output / "lidar/trajectory.tum")) {
    if (const auto errors = drive_errors(reference, *way)) row.errors = *errors;
  }
  if (const auto map = read_ply(output / "lidar/map.ply")) {
    row.thickness_m = plane_thickness_m(*map);
  }
  return row;
}

/// The poses of a peer as those of the IMU.
Trajectory of_imu(const Arguments& arguments, const fs::path& folder, Trajectory way) {
  const auto sensors = read_sensors_yaml(folder / "sensors.yaml");
  const Rigid3 imu_from_lidar = sensors ? sensors->imu_from_lidar.value_or(Rigid3{}) : Rigid3{};
  for (StampedPose& pose : way.poses) {
    pose.time += from_seconds(arguments.peer_delay_s);
    if (arguments.peer_frame == "lidar") {
      pose.map_from_body = pose.map_from_body * imu_from_lidar.inverse();
    }
  }
  return way;
}

RealDriveRow peer_row(const Arguments& arguments,
                      const fs::path& folder,
                      const std::string& name,
                      const fs::path& trajectory,
                      const Trajectory& reference) {
  RealDriveRow row{
      .drive = folder.filename().string(), .program = name, .num_scans = count_scans(folder)};
  if (const auto way = read_tum(trajectory)) {
    const auto errors = drive_errors(reference, of_imu(arguments, folder, *way));
    if (errors) row.errors = *errors;
  }
  return row;
}

std::vector<RealDriveRow> run_peers(const Arguments& arguments,
                                    const fs::path& folder,
                                    const Trajectory& reference) {
  std::vector<RealDriveRow> rows;
  const std::string drive = folder.filename().string();
  for (const std::string& peer : arguments.peers) {
    const auto [name, command] = split(peer);
    const fs::path output = fs::path(arguments.work) / fmt::format("{}-{}.tum", drive, name);
    fs::remove(output);
    const auto run = run_program(replaced(replaced(command, "{folder}", quoted(folder.string())),
                                          "{output}",
                                          quoted(output.string())),
                                 fs::path(arguments.work) / fmt::format("{}-{}.log", drive, name),
                                 arguments.limit_s);
    RealDriveRow row = peer_row(arguments, folder, name, output, reference);
    if (run) row.run = *run;
    rows.push_back(row);
  }
  for (const std::string& peer : arguments.peer_trajectories) {
    const auto [name, file] = split(peer);
    rows.push_back(peer_row(arguments, folder, name, replaced(file, "{drive}", drive), reference));
  }
  return rows;
}

/// The drives of HYBRIDFUSION_TEST_DATA where none is named.
std::vector<fs::path> drives_of(const Arguments& arguments) {
  std::vector<fs::path> folders;
  for (const std::string& folder : arguments.folders) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    folders.push_back(path.has_filename() ? path : path.parent_path());
  }
  const char* data = std::getenv("HYBRIDFUSION_TEST_DATA");  // NOLINT(concurrency-mt-unsafe)
  if (!folders.empty() || data == nullptr) return folders;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(fs::path(data) / "lidar-real", code)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  return folders;
}

int run_all(const Arguments& arguments) {
  const std::vector<fs::path> folders = drives_of(arguments);
  if (folders.empty()) {
    std::cerr << "no drives: name folders, or set HYBRIDFUSION_TEST_DATA\n";
    return 2;
  }
  fs::create_directories(arguments.work);
  std::vector<RealDriveRow> rows;
  for (const fs::path& folder : folders) {
    const auto reference = read_tum(folder / arguments.reference);
    if (!reference) {
      std::cerr << reference.error().message << '\n';
      return 3;
    }
    std::cerr << folder.filename().string() << '\n';
    rows.push_back(run_ours(arguments, folder, *reference));
    std::ranges::copy(run_peers(arguments, folder, *reference), std::back_inserter(rows));
  }
  if (!arguments.json) {
    std::cout << table(rows);
    return 0;
  }
  nlohmann::json json = nlohmann::json::array();
  for (const RealDriveRow& row : rows) json.push_back(to_json(row));
  std::cout << json.dump(1) << '\n';
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs `hybridfusion map` on recorded drives that have a reference trajectory.");
  Arguments arguments;
  arguments.program = program_beside().string();
  arguments.work = (fs::temp_directory_path() / "hybridfusion-real-drives").string();
  app.add_option("folders",
                 arguments.folders,
                 "Folders of .pcd scans, imu.csv, sensors.yaml and a reference; default: those of "
                 "HYBRIDFUSION_TEST_DATA/lidar-real");
  app.add_option("--program", arguments.program, "The program")->capture_default_str();
  app.add_option("--work", arguments.work, "Folder for what the programs write")
      ->capture_default_str();
  app.add_option("--reference", arguments.reference, "File of IMU poses in each folder")
      ->capture_default_str();
  app.add_option("--peer",
                 arguments.peers,
                 "NAME=COMMAND of another program, with {folder} for the drive and {output} for "
                 "the TUM file it is to write; repeatable")
      ->allow_extra_args(false);
  app.add_option("--peer-trajectory",
                 arguments.peer_trajectories,
                 "NAME=FILE that another program has written, {drive} in it for the name of the "
                 "folder; repeatable")
      ->allow_extra_args(false);
  app.add_option("--peer-frame", arguments.peer_frame, "Body whose poses peers write: lidar, imu")
      ->check(CLI::IsMember({"lidar", "imu"}))
      ->capture_default_str();
  app.add_option("--peer-delay", arguments.peer_delay_s, "Added to the stamps of peers [s]")
      ->capture_default_str();
  app.add_option("--limit", arguments.limit_s, "Time for each run [s]")->capture_default_str();
  app.add_flag("--json", arguments.json, "One JSON array instead of the Markdown table");
  CLI11_PARSE(app, argc, argv);
  return run_all(arguments);
}
