#include "signals.hpp"

#include <atomic>
#include <chrono>
#include <csignal>

#include <unistd.h>

namespace hybridfusion::cli {
namespace {

/// The first signal that asked the process to end. Global because a handler has no other way.
std::atomic<int> first_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

/// Handlers and not a blocked mask with sigwait: libraries start threads before main (OpenBLAS
/// does), which leave the signals unblocked and would let the default action kill the process.
void on_signal(int number) {
  int none = 0;
  if (!first_signal.compare_exchange_strong(none, number)) _exit(128 + number);
}

}  // namespace

SignalWatch::SignalWatch() {
  // A file that grows past a limit is then an error of write(), told with path and bytes.
  ::signal(SIGXFSZ, SIG_IGN);
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) sigaction(number, &action, nullptr);
  watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

SignalWatch::~SignalWatch() = default;

int SignalWatch::signal() const {
  return first_signal;
}

void SignalWatch::watch(const std::stop_token& end) {
  constexpr std::chrono::milliseconds kPoll{50};
  while (!end.stop_requested()) {
    if (first_signal != 0) stop_.request_stop();
    std::this_thread::sleep_for(kPoll);
  }
}

}  // namespace hybridfusion::cli
