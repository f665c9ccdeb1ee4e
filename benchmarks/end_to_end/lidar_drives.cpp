// Simulated drives and recordings with truth through module B, one process a run, one table. See
// --help.
#include "drive_table.hpp"
#include "settings.hpp"

#include <hybridfusion/simulation/simulate.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <iostream>
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
  std::vector<std::uint64_t> seeds = {1};
  std::vector<std::string> only = {};
  std::vector<std::string> runs = {};
  std::vector<std::string> recordings = {};
  std::vector<std::string> settings = {};
  std::string work = {};
  bool keep = false;
  bool json = false;
  std::string child = {};    // folder to run one variant on, in a process of its own
  std::string details = {};  // and where it leaves its files
};

bool wanted(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

int run_child(const Arguments& arguments) {
  for (Variant variant : variants()) {
    if (!wanted(arguments.runs, variant.name)) continue;
    if (auto applied = apply_settings(arguments.settings, variant.options); !applied) {
      std::cerr << applied.error().message << '\n';
      return 2;
    }
    const auto figures = run_variant(variant, arguments.child, arguments.details);
    if (!figures) {
      std::cerr << figures.error().message << '\n';
      return 1;
    }
    std::cout << to_json(*figures).dump() << '\n';
    return 0;
  }
  return 2;
}

/// The variant in a fresh process, so that its peak memory is its own.
Expected<Figures> run_apart(const Arguments& arguments,
                            const Variant& variant,
                            const fs::path& folder,
                            const fs::path& details) {
  const std::string self = fs::read_symlink("/proc/self/exe");
  std::string command = fmt::format("'{}' --child '{}' --details '{}' --runs {}",
                                    self,
                                    folder.string(),
                                    details.string(),
                                    variant.name);
  for (const std::string& setting : arguments.settings)
    command += fmt::format(" --set '{}'", setting);
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return fail(ErrorCode::kIo, "cannot start " + command);
  std::string text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  if (pclose(pipe) != 0 || !nlohmann::json::accept(text)) {
    return fail(ErrorCode::kIo, fmt::format("'{}' failed on {}", variant.name, folder.string()));
  }
  return from_json(nlohmann::json::parse(text));
}

/// Every variant on one data set.
Expected<void> run_variants(const Arguments& arguments,
                            const DriveKind& kind,
                            std::uint64_t seed,
                            const fs::path& folder,
                            const fs::path& details,
                            std::vector<Row>& rows) {
  for (const Variant& variant : variants()) {
    if (!wanted(arguments.runs, variant.name)) continue;
    std::cerr << fmt::format("{}, seed {}: {}\n", kind.name, seed, variant.name);
    HF_TRY(const Figures figures, run_apart(arguments, variant, folder, details));
    rows.push_back({.kind = &kind,
                    .seed = seed,
                    .variant = variant.name,
                    .offline = variant.offline,
                    .figures = figures});
  }
  return {};
}

Expected<void> run_kind(const Arguments& arguments,
                        const DriveKind& kind,
                        std::uint64_t seed,
                        std::vector<Row>& rows) {
  const fs::path folder = fs::path(arguments.work) / fmt::format("{}-{}", kind.name, seed);
  // simulate() leaves the folder only when it is complete.
  const bool made = !fs::exists(folder);
  if (made) {
    std::cerr << fmt::format("{}, seed {}: simulating\n", kind.name, seed);
    auto done = simulate(folder, kind.simulation, {.seed = seed});
    if (!done) return std::unexpected(done.error());
    std::cerr << fmt::format("  {} scans, {:.0f} m\n", done->scans, done->path_m);
  }
  auto done = run_variants(arguments, kind, seed, folder, folder, rows);
  if (made && !arguments.keep) fs::remove_all(folder);
  return done;
}

/// A data set with truth that was there before; its folder stays as it is.
Expected<void> run_recording(const Arguments& arguments,
                             const DriveKind& kind,
                             const fs::path& folder,
                             std::vector<Row>& rows) {
  const fs::path details = fs::path(arguments.work) / ("recording-" + kind.name);
  std::error_code code;
  fs::create_directories(details, code);
  auto done = run_variants(arguments, kind, 0, folder, details, rows);
  if (!arguments.keep) fs::remove_all(details, code);
  return done;
}

Expected<void> run_everything(const Arguments& arguments,
                              std::deque<DriveKind>& recordings,
                              std::vector<Row>& rows) {
  for (const DriveKind& kind : drive_kinds()) {
    const bool asked = arguments.only.empty() ? kind.unasked && arguments.recordings.empty()
                                              : wanted(arguments.only, kind.name);
    if (!asked) continue;
    for (const std::uint64_t seed : arguments.seeds) {
      if (auto done = run_kind(arguments, kind, seed, rows); !done) return done;
    }
  }
  for (const std::string& recording : arguments.recordings) {
    const fs::path folder = fs::absolute(recording).lexically_normal();
    const fs::path name =
        folder.has_filename() ? folder.filename() : folder.parent_path().filename();
    recordings.push_back({.name = name.string()});
    if (auto done = run_recording(arguments, recordings.back(), folder, rows); !done) return done;
  }
  return {};
}

int run_all(const Arguments& arguments) {
  std::deque<DriveKind> recordings;  // rows point into it
  std::vector<Row> rows;
  std::error_code code;
  fs::create_directories(arguments.work, code);
  if (auto done = run_everything(arguments, recordings, rows); !done) {
    std::cerr << done.error().message << '\n';
    return 1;
  }
  std::cout << (arguments.json ? table_json(rows).dump(1) + "\n" : table(rows));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Simulates kinds of drive and measures LiDAR odometry and mapping on them.");
  Arguments arguments;
  arguments.work = (fs::temp_directory_path() / "hybridfusion-lidar-drives").string();
  app.add_option("--seeds", arguments.seeds, "Worlds and noise; comma separated")->delimiter(',');
  std::string kinds;
  for (const DriveKind& kind : drive_kinds()) {
    kinds += fmt::format("{}{} ({})", kinds.empty() ? "" : ", ", kind.name, kind.text);
  }
  std::string runs;
  for (const Variant& variant : variants()) runs += (runs.empty() ? "" : ", ") + variant.name;
  app.add_option("--only", arguments.only, "Drives, comma separated: " + kinds)->delimiter(',');
  app.add_option("--runs", arguments.runs, "Runs, comma separated: " + runs)->delimiter(',');
  app.add_option(
         "--recordings",
         arguments.recordings,
         "Data sets with truth (street.bag, sensors.yaml, truth/) to measure instead of, or "
         "with --only besides, simulated drives; comma separated")
      ->delimiter(',');
  app.add_option("--set", arguments.settings, "Option below lidar.odometry, key=value; repeatable")
      ->allow_extra_args(false);
  app.add_option("--work", arguments.work, "Folder for the recordings; those there are reused")
      ->capture_default_str();
  app.add_flag("--keep", arguments.keep, "Leave the recordings (up to 1 GB each)");
  app.add_flag("--json", arguments.json, "One JSON array instead of the Markdown table");
  app.add_option("--child", arguments.child)->group("");
  app.add_option("--details", arguments.details)->group("");
  CLI11_PARSE(app, argc, argv);
  return arguments.child.empty() ? run_all(arguments) : run_child(arguments);
}
