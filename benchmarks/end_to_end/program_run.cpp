#include "program_run.hpp"

#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hybridfusion::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// In the child: never returns.
[[noreturn]] void become(const std::string& command, const std::filesystem::path& log) {
  setpgid(0, 0);  // so that a limit ends what the shell started, too
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }
  execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
  _exit(127);
}

}  // namespace

Expected<ProgramRun> run_program(const std::string& command,
                                 const std::filesystem::path& log,
                                 double limit_s) {
  constexpr int kTimedOut = 124;  // as timeout(1)
  constexpr int kSignalled = 128;
  const Clock::time_point begin = Clock::now();
  const pid_t child = fork();
  if (child < 0) return fail(ErrorCode::kIo, "cannot start " + command);
  if (child == 0) become(command, log);
  int status = 0;
  rusage usage{};
  bool ended = false;
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (!ended && seconds_since(begin) > limit_s) {
      kill(-child, SIGKILL);
      ended = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ProgramRun run{.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime),
                 .wall_s = seconds_since(begin),
                 .peak_mib = static_cast<double>(usage.ru_maxrss) / 1024.0};
  run.exit_code = ended               ? kTimedOut
                  : WIFEXITED(status) ? WEXITSTATUS(status)
                                      : kSignalled + WTERMSIG(status);
  return run;
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      out += "'\\''";
    } else {
      out += letter;
    }
  }
  return out + "'";
}

std::filesystem::path program_beside() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "hybridfusion";
}

}  // namespace hybridfusion::benchmark
