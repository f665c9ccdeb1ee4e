#include "console.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace hybridfusion::cli {
namespace {

constexpr std::chrono::milliseconds kBarPeriod{100};
constexpr std::chrono::seconds kLinePeriod{10};
constexpr int kBarWidth = 24;

std::string bar_of(double share) {
  const int filled = static_cast<int>(std::lround(share * kBarWidth));
  return std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarWidth - filled), '.');
}

}  // namespace

struct Console::Logger {
  std::shared_ptr<spdlog::logger> spd;
};

Console::Console(const GlobalOptions& options)
    : logger_(std::make_unique<Logger>()),
      quiet_(options.quiet),
      terminal_(::isatty(STDERR_FILENO) == 1) {
  logger_->spd = std::make_shared<spdlog::logger>(
      "hybridfusion", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  logger_->spd->set_pattern("%^%l%$: %v");
  logger_->spd->set_level(options.quiet     ? spdlog::level::err
                          : options.verbose ? spdlog::level::debug
                                            : spdlog::level::info);
}

Console::~Console() {
  const std::scoped_lock lock(mutex_);
  clear_bar();
}

void Console::log(LogLevel level, std::string_view message) {
  const std::scoped_lock lock(mutex_);
  clear_bar();
  const auto severity = level == LogLevel::kDebug  ? spdlog::level::debug
                        : level == LogLevel::kInfo ? spdlog::level::info
                                                   : spdlog::level::warn;
  logger_->spd->log(severity, "{}", message);
}

void Console::error(std::string_view message) {
  const std::scoped_lock lock(mutex_);
  clear_bar();
  logger_->spd->error("{}", message);
}

void Console::progress(const ProgressEvent& event) {
  if (quiet_) return;
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (event.stage != stage_) {
    stage_ = event.stage;
    stage_start_ = now;
    last_shown_ = terminal_ ? std::chrono::steady_clock::time_point{} : now;
  }
  if (now - last_shown_ < (terminal_ ? std::chrono::nanoseconds(kBarPeriod) : kLinePeriod)) return;
  last_shown_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - stage_start_).count();
  if (event.total <= 0) {
    draw_bar(fmt::format("{}: {} done, {} passed", stage_, event.done, duration_text(elapsed_s)));
    return;
  }
  const double share =
      std::clamp(static_cast<double>(event.done) / static_cast<double>(event.total), 0.0, 1.0);
  const std::string left =
      share > 0.0 ? duration_text(elapsed_s * (1.0 - share) / share) : std::string("?");
  draw_bar(
      fmt::format("{} [{}] {}/{}, {} left", stage_, bar_of(share), event.done, event.total, left));
}

void Console::draw_bar(std::string_view line) {
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{}", line);
    std::fflush(stderr);
    bar_shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
}

void Console::clear_bar() {
  if (!bar_shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  bar_shown_ = false;
}

std::string duration_text(double seconds) {
  const auto total = static_cast<long>(std::lround(std::max(0.0, seconds)));
  if (total < 3600) return fmt::format("{}:{:02}", total / 60, total % 60);
  return fmt::format("{}:{:02}:{:02}", total / 3600, total / 60 % 60, total % 60);
}

}  // namespace hybridfusion::cli
