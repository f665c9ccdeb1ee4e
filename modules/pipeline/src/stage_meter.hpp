#pragma once

#include <hybridfusion/pipeline/stages.hpp>

#include <chrono>

namespace hybridfusion {

/// Measures what a stage costs, from its construction to cost(). The peak memory is that of the
/// stage alone where the system can reset it (Linux), else that of the process so far.
class StageMeter {
 public:
  StageMeter();
  [[nodiscard]] StageCost cost() const;

 private:
  std::chrono::steady_clock::time_point start_;
  double start_cpu_s_ = 0.0;
};

}  // namespace hybridfusion
