#include "signals.hpp"

#include <csignal>
#include <ctime>

#include <pthread.h>
#include <unistd.h>

namespace hybridfusion::cli {
namespace {

sigset_t ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

SignalWatch::SignalWatch() {
  // A file that grows past a limit is then an error of write(), told with path and bytes.
  ::signal(SIGXFSZ, SIG_IGN);
  const sigset_t set = ending_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

SignalWatch::~SignalWatch() = default;

void SignalWatch::watch(const std::stop_token& end) {
  const sigset_t set = ending_signals();
  constexpr timespec kPoll{.tv_sec = 0, .tv_nsec = 100'000'000};
  while (!end.stop_requested()) {
    const int number = sigtimedwait(&set, nullptr, &kPoll);
    if (number <= 0) continue;
    if (signal_ != 0) _exit(128 + number);
    signal_ = number;
    stop_.request_stop();
  }
}

}  // namespace hybridfusion::cli
