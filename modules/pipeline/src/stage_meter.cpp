#include "stage_meter.hpp"

#include <hybridfusion/core/memory.hpp>

#include <fstream>
#include <string>

#include <sys/resource.h>

namespace hybridfusion {
namespace {

double process_cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kib = 0.0;
    if (word == "VmHWM:" && status >> kib) return kib / 1024.0;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace

StageMeter::StageMeter() : start_(std::chrono::steady_clock::now()), start_cpu_s_(process_cpu_s()) {
  return_freed_memory();  // what the stage before freed is not this one's memory
  std::ofstream("/proc/self/clear_refs") << "5";  // resets VmHWM; harmless where it is refused
}

StageCost StageMeter::cost() const {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start_;
  return {.wall_s = wall.count(),
          .cpu_s = process_cpu_s() - start_cpu_s_,
          .peak_memory_mib = peak_memory_mib()};
}

}  // namespace hybridfusion
