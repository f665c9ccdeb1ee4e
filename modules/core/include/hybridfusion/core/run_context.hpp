#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>

namespace hybridfusion {

enum class LogLevel : std::uint8_t { kDebug, kInfo, kWarning };

struct ProgressEvent {
  std::string_view stage;  ///< "registration/patch_match"
  std::int64_t done = 0;
  std::int64_t total = 0;  ///< 0 when unknown.
};

/// What a long computation needs from whoever runs it. Libraries write to no stream and read no
/// global: they log, report and stop through this. The default is silent, uninterruptible and uses
/// every core.
struct RunContext {
  std::function<void(LogLevel, std::string_view)> log = {};
  std::function<void(const ProgressEvent&)> progress = {};
  std::stop_token stop = {};
  int num_threads = 0;     ///< 0: all cores.
  std::uint64_t seed = 0;  ///< Every random choice derives from this.

  [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
  void info(std::string_view message) const {
    if (log) log(LogLevel::kInfo, message);
  }
  void warn(std::string_view message) const {
    if (log) log(LogLevel::kWarning, message);
  }
  void report(const ProgressEvent& event) const {
    if (progress) progress(event);
  }
};

}  // namespace hybridfusion
