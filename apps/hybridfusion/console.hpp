#pragma once

#include "cli.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace hybridfusion::cli {

/// Log and progress on stderr. On a terminal progress is a bar with the time left that redraws
/// itself; elsewhere it is one line every ten seconds.
class Console {
 public:
  explicit Console(const GlobalOptions& options);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  void log(LogLevel level, std::string_view message);
  void error(std::string_view message);
  void progress(const ProgressEvent& event);

 private:
  struct Logger;
  void clear_bar();
  void draw_bar(std::string_view line);

  std::unique_ptr<Logger> logger_;
  bool quiet_ = false;
  bool terminal_ = false;
  bool bar_shown_ = false;
  std::mutex mutex_ = {};
  std::string stage_ = {};
  std::chrono::steady_clock::time_point stage_start_ = {};
  std::chrono::steady_clock::time_point last_shown_ = {};
};

/// "1:05" or "2:03:10".
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace hybridfusion::cli
