#include "child_process.hpp"

#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace hybridfusion::testing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

[[noreturn]] void become(std::vector<char*>& argv, const std::map<int, int>& descriptors) {
  ::setpgid(0, 0);  // its own children end with it
  constexpr int kAside = 100;
  for (const auto& [theirs, ours] : descriptors) ::dup2(ours, theirs + kAside);
  for (const auto& [theirs, ours] : descriptors) {
    ::dup2(theirs + kAside, theirs);
    ::close(theirs + kAside);
  }
  if (!descriptors.contains(STDERR_FILENO)) ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
  if (!descriptors.contains(STDOUT_FILENO)) ::dup2(::open("/dev/null", O_WRONLY), STDOUT_FILENO);
  ::execvp(argv.front(), argv.data());
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments,
                           const std::map<int, int>& descriptors) {
  std::vector<std::string> owned = arguments;
  std::vector<char*> argv;
  for (std::string& argument : owned) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ == 0) become(argv, descriptors);
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) end(SIGTERM, 5.0);
}

int ChildProcess::end(int signal, double patience_s) {
  ::kill(pid_, signal);
  const auto start = Clock::now();
  int status = 0;
  bool killed = false;
  while (::waitpid(pid_, &status, WNOHANG) == 0) {
    if (!killed && seconds_since(start) > patience_s) {
      ::kill(-pid_, SIGKILL);
      killed = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(-pid_, SIGKILL);  // helpers that it left
  pid_ = -1;
  if (killed) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Pipe::Pipe() {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) == 0) read_end = ends[0], write_end = ends[1];
}
Pipe::~Pipe() {
  close_read();
  close_write();
}
void Pipe::close_read() {
  if (read_end >= 0) ::close(read_end);
  read_end = -1;
}
void Pipe::close_write() {
  if (write_end >= 0) ::close(write_end);
  write_end = -1;
}

std::string read_until(int descriptor, char delimiter, std::string& rest, double patience_s) {
  const auto start = Clock::now();
  while (true) {
    if (const std::size_t end = rest.find(delimiter); end != std::string::npos) {
      std::string message = rest.substr(0, end);
      rest.erase(0, end + 1);
      return message;
    }
    const double left_s = patience_s - seconds_since(start);
    pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
    if (left_s <= 0.0 || ::poll(&waiting, 1, static_cast<int>(1000.0 * left_s) + 1) <= 0) return {};
    char buffer[65536];
    const ssize_t got = ::read(descriptor, buffer, sizeof(buffer));
    if (got <= 0) return {};
    rest.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace hybridfusion::testing
