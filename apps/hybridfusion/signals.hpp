#pragma once

#include <stop_token>
#include <thread>

namespace hybridfusion::cli {

/// Turns SIGINT and SIGTERM into a stop request; a second signal ends the process at once.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  [[nodiscard]] std::stop_token token() const { return stop_.get_token(); }
  /// The signal that came, or 0.
  [[nodiscard]] int signal() const;

 private:
  void watch(const std::stop_token& end);

  std::stop_source stop_ = {};
  std::jthread watcher_ = {};
};

}  // namespace hybridfusion::cli
