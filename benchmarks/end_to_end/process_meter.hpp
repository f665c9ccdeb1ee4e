#pragma once

#include <hybridfusion/core/memory.hpp>

#include <fstream>
#include <string>

#include <sys/resource.h>

namespace hybridfusion::benchmark {

/// User and system time of this process so far [s].
inline double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Peak of the resident memory above what it was when the meter was made.
class MemoryMeter {
 public:
  MemoryMeter() {
    return_freed_memory();  // what earlier work freed would hide what this one takes
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts again at the present value
    before_kb_ = field_kb("VmRSS:");
  }
  [[nodiscard]] double peak_mb() const { return (field_kb("VmHWM:") - before_kb_) / 1024.0; }

 private:
  static double field_kb(const std::string& name) {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kb = 0.0;
    while (status >> word) {
      if (word == name && status >> kb) return kb;
    }
    return 0.0;
  }

  double before_kb_ = 0.0;
};

}  // namespace hybridfusion::benchmark
