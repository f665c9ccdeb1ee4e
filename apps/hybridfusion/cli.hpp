#pragma once

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/pipeline/stages.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace hybridfusion::cli {

/// Exit codes, the contract with scripts.
enum ExitCode : int {
  kDone = 0,
  kUsage = 2,
  kBadInput = 3,
  kRefused = 4,
  kOutOfResource = 5,
  kInternal = 70,
  kInterrupted = 130,
  kTerminated = 143,
};

/// Options of every command.
struct GlobalOptions {
  std::string config = {};
  std::vector<std::string> settings = {};
  int threads = 0;
  std::uint64_t seed = 0;
  bool quiet = false;
  bool verbose = false;
  bool json = false;
};

/// What a command works with once the command line is understood.
struct Session {
  const GlobalOptions& globals;
  RunContext context = {};
  PipelineOptions& options;                                ///< --config and --set applied.
  std::function<void(std::string_view)> print_error = {};  ///< To stderr, --quiet or not.
};

using Command = std::function<int(Session&)>;

/// Each adds its subcommand; parsing stores in `chosen` what is to be done.
void add_run_command(CLI::App& app, Command& chosen);
void add_reconstruct_command(CLI::App& app, Command& chosen);
void add_map_command(CLI::App& app, Command& chosen);
void add_register_command(CLI::App& app, Command& chosen);
void add_evaluate_command(CLI::App& app, Command& chosen);
void add_convert_command(CLI::App& app, Command& chosen);
void add_config_command(CLI::App& app, Command& chosen);
void add_simulate_command(CLI::App& app, Command& chosen);
void add_view_command(CLI::App& app, Command& chosen);
void add_doctor_command(CLI::App& app, Command& chosen);
void add_completion_command(CLI::App& app, Command& chosen);

/// `--set` keys of the simulator; it is no stage of the pipeline, so its options are apart.
inline constexpr std::string_view kSimulationPrefix = "simulation.";

/// Rows of the option reference for the simulator.
[[nodiscard]] std::string simulation_reference();

/// What --bag takes.
inline constexpr const char* kRecordingHelp =
    "Recording of LiDAR, IMU and GNSS: ROS 1 .bag, ROS 2 bag folder, .db3 or .mcap, one of these "
    "as .zst, or a folder of .pcd scans with imu.csv";

/// Absent for an option that was not given.
[[nodiscard]] std::optional<std::filesystem::path> optional_path(const std::string& text);

/// What `run` and `reconstruct` know of photos.
struct PhotoArguments {
  std::string images = {};
  std::string poses = {};
  std::string geo = {};
  std::string gcp = {};
};
void add_photo_options(CLI::App& command, PhotoArguments& arguments);
[[nodiscard]] PhotoInputs photo_inputs(const PhotoArguments& arguments);

/// The end of every --help: what the command reads and writes, an example, and the options common
/// to all commands.
[[nodiscard]] std::string help_footer(const std::string& example,
                                      const std::string& reads = {},
                                      const std::string& writes = {});

/// Prints the error (on stdout as JSON with --json) and returns its exit code.
[[nodiscard]] int report_error(const Session& session, const Error& error);

/// The result of a stage on stdout, as JSON with --json.
void print_outcome(const Session& session, const StageOutcome& outcome);

/// Runs stages one after the other, prints what each has to say, and stops at the first error. A
/// refused one does not stop those behind it but decides the exit code.
[[nodiscard]] int run_stages(
    Session& session,
    const std::string& output,
    const std::vector<std::string>& forced,
    const std::vector<std::function<Expected<StageOutcome>(Project&)>>& stages);

}  // namespace hybridfusion::cli
