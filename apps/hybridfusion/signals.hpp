#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace hybridfusion::cli {

/// Turns SIGINT and SIGTERM into a stop request; a second signal ends the process at once. Create
/// it before any other thread, so that all of them leave the signals to this one.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  /// The signal that came, or 0.
  [[nodiscard]] int signal() const { return signal_; }

 private:
  void watch(const std::stop_token& end);

  std::stop_source stop_ = {};
  std::atomic<int> signal_ = 0;
  std::jthread watcher_ = {};
};

}  // namespace hybridfusion::cli
