// Simulated drives that roll when the recording begins, sound and faulty ones, through the
// installed program: what it claims against the truth. See --help.
#include "drive_errors.hpp"
#include "program_run.hpp"
#include "rolling_cases.hpp"
#include "rolling_verdict.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/tum.hpp>
#include <hybridfusion/simulation/simulate.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

namespace {

using namespace hybridfusion;             // NOLINT(google-build-using-namespace): a program
using namespace hybridfusion::benchmark;  // NOLINT(google-build-using-namespace)
namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Arguments {
  int count = 100;
  std::uint64_t seed = 1;
  std::vector<int> only = {};
  std::string program = {};
  std::string work = {};
  double limit_s = 600.0;
  bool keep = false;
  bool json = false;
  int simulate = -1;  // a case to simulate, in a process of its own
};

std::string last_words(const fs::path& log) {
  std::ifstream in(log);
  std::string words;
  for (std::string line; std::getline(in, line);) {
    if (line.find("not reliable") != std::string::npos || line.starts_with("error")) words = line;
  }
  return words;
}

Expected<Json> run_case(const Arguments& arguments, const RollingCase& drive) {
  const fs::path folder = fs::path(arguments.work) / fmt::format("case-{:03}", drive.number);
  fs::remove_all(folder);
  const fs::path log = folder.string() + ".log";
  // Apart, so that the memory of the simulation is not that of this process, which runs inherit.
  HF_TRY(const ProgramRun made,
         run_program(fmt::format("{} --simulate {} --seed {} --work {}",
                                 quoted(fs::read_symlink("/proc/self/exe").string()),
                                 drive.number,
                                 arguments.seed,
                                 quoted(arguments.work)),
                     log,
                     arguments.limit_s));
  if (made.exit_code != 0)
    return fail(ErrorCode::kIo, "the simulation failed, see " + log.string());
  const fs::path workspace = folder / "workspace";
  HF_TRY(const ProgramRun run,
         run_program(fmt::format("{} map --bag {} --sensors {} --output {} --threads 1",
                                 quoted(arguments.program),
                                 quoted((folder / "street.bag").string()),
                                 quoted((folder / "sensors.yaml").string()),
                                 quoted(workspace.string())),
                     log,
                     arguments.limit_s));
  Json row = {{"case", drive.number},
              {"text", drive.text},
              {"fault", drive.fault},
              {"speed_mps", drive.speed_mps},
              {"exit", run.exit_code},
              {"peak_mib", run.peak_mib},
              {"cause", last_words(log)}};
  HF_TRY(const Trajectory truth, read_tum(folder / "truth/trajectory_imu.tum"));
  std::optional<DriveErrors> errors;
  if (const auto way = read_tum(workspace / "lidar/trajectory.tum")) {
    row["cpu_ms"] =
        1e3 * run.cpu_s / static_cast<double>(std::max<std::size_t>(1, way->poses.size()));
    if (const auto found = drive_errors(truth, *way)) errors = *found;
  }
  if (errors) {
    row["path_m"] = errors->path_m;
    row["path_ratio"] = errors->path_ratio;
    row["ate_m"] = errors->ate_m;
    row["tilt_deg"] = errors->tilt_deg;
    add_claims(workspace, *errors, row);
  }
  row["verdict"] = verdict(drive, row, errors);
  if (!arguments.keep) fs::remove_all(folder);
  return row;
}

/// Holds a case for this process; given back by the system when the process ends, however it does.
class Claim {
 public:
  explicit Claim(const fs::path& path)
      : file_(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) != 0) {
      close(file_);
      file_ = -1;
    }
  }
  ~Claim() {
    if (file_ >= 0) close(file_);
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  [[nodiscard]] bool held() const { return file_ >= 0; }

 private:
  int file_;
};

int run_all(const Arguments& arguments) {
  fs::create_directories(arguments.work);
  std::vector<int> numbers = arguments.only;
  for (int i = 0; i < arguments.count && arguments.only.empty(); ++i) numbers.push_back(i);
  std::vector<Json> rows;
  for (const int i : numbers) {
    const std::string name =
        (fs::path(arguments.work) / fmt::format("seed-{}-case-{:03}", arguments.seed, i)).string();
    const Claim claim(name + ".lock");
    if (!claim.held()) continue;  // another process is at it
    Json row = read_json(name + ".json");
    if (!row.is_object()) {
      const RollingCase drive = rolling_case(i, arguments.seed);
      std::cerr << fmt::format(
          "{}: {}{}{}\n", i, drive.text, drive.fault.empty() ? "" : ", ", drive.fault);
      const auto done = run_case(arguments, drive);
      if (!done) {
        std::cerr << done.error().message << '\n';
        return 1;
      }
      row = *done;
      if (!write_file_atomically(name + ".json", row.dump(1))) return 5;
    }
    rows.push_back(row);
  }
  std::cout << (arguments.json ? Json(rows).dump(1) + "\n" : table(rows) + "\n" + totals(rows));
  return 0;
}

int simulate_case(const Arguments& arguments) {
  const RollingCase drive = rolling_case(arguments.simulate, arguments.seed);
  const auto done = simulate(fs::path(arguments.work) / fmt::format("case-{:03}", drive.number),
                             drive.simulation,
                             {.num_threads = 1, .seed = drive.seed});
  if (done) return 0;
  std::cerr << done.error().message << '\n';
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Simulates drives that roll at 0 to 30 m/s when their recording begins, a fifth of them "
      "faulty, maps them, and compares what the program claims with the truth.");
  Arguments arguments;
  arguments.program = program_beside().string();
  arguments.work = (fs::temp_directory_path() / "hybridfusion-rolling-starts").string();
  app.add_option("--count", arguments.count, "Drives")->capture_default_str();
  app.add_option("--seed", arguments.seed, "Of all drives")->capture_default_str();
  app.add_option("--only", arguments.only, "Numbers of cases, comma separated")->delimiter(',');
  app.add_option("--program", arguments.program, "The program")->capture_default_str();
  app.add_option("--work",
                 arguments.work,
                 "Folder for results; cases there are not run again, and several processes may "
                 "share it")
      ->capture_default_str();
  app.add_option("--limit", arguments.limit_s, "Time for each run [s]")->capture_default_str();
  app.add_flag("--keep", arguments.keep, "Leave the recordings and workspaces");
  app.add_flag("--json", arguments.json, "One JSON array instead of the Markdown table");
  app.add_option("--simulate", arguments.simulate)->group("");
  CLI11_PARSE(app, argc, argv);
  return arguments.simulate >= 0 ? simulate_case(arguments) : run_all(arguments);
}
