#pragma once

#include <hybridfusion/core/error.hpp>

#include <filesystem>
#include <string>

namespace hybridfusion::benchmark {

/// How a program ended and what it took.
struct ProgramRun {
  int exit_code = 0;  ///< 128 + the signal when one ended it; 124: it ran out of time.
  double cpu_s = 0.0;
  double wall_s = 0.0;
  double peak_mib = 0.0;  ///< Resident, at least that of this process at the start.
};

/// Runs a shell command to its end, its output in the file `log`.
/// @returns kIo when it cannot be started.
[[nodiscard]] Expected<ProgramRun> run_program(const std::string& command,
                                               const std::filesystem::path& log,
                                               double limit_s);

/// `text` in single quotes for the shell.
[[nodiscard]] std::string quoted(const std::string& text);

/// bin/hybridfusion beside this program.
[[nodiscard]] std::filesystem::path program_beside();

}  // namespace hybridfusion::benchmark
