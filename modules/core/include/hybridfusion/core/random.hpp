#pragma once

#include <cstdint>
#include <string_view>

namespace hybridfusion {

/// Seeded stream of random numbers, the same on every platform (the standard's distributions are
/// not). One stream per purpose: `Random(ctx.seed, "vision/ransac", pair_index)`, so that stages do
/// not disturb each other. Generator: PCG32 (O'Neill 2014).
class Random {
 public:
  Random(std::uint64_t seed, std::string_view stream, std::uint64_t index = 0);

  [[nodiscard]] std::uint32_t next_u32();
  /// Uniform in [0, 1).
  [[nodiscard]] double uniform();
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in [0, count). @pre count > 0
  [[nodiscard]] std::uint32_t index(std::uint32_t count);
  /// Standard normal (Box-Muller).
  [[nodiscard]] double normal();

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_ = 1;
  double spare_normal_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace hybridfusion
