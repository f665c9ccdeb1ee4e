#pragma once

#include "path_aggregation.hpp"

#include <cstdint>
#include <cstring>

// Vectors are passed between functions that are always inlined: no call depends on their ABI.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace hybridfusion {

// GCC's vector extension: the compiler maps it to whatever the target of each clone has.
using Lanes [[gnu::vector_size(2 * kDisparityLanes)]] = std::int16_t;
using Bytes [[gnu::vector_size(kDisparityLanes)]] = std::uint8_t;

[[gnu::always_inline]] inline Lanes load(const std::int16_t* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[gnu::always_inline]] inline Lanes load_bytes(const std::uint8_t* from) {
  Bytes bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(bytes, Lanes);
}

[[gnu::always_inline]] inline void store(std::int16_t* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return a < b ? a : b;
}

[[gnu::always_inline]] inline Lanes splat(std::int16_t value) {
  return Lanes{} + value;
}

/// Halves are exchanged as pairs of lanes: GCC 12 would move single ones one by one.
[[gnu::always_inline]] inline std::int16_t smallest(const Lanes& lanes) {
  using Half [[gnu::vector_size(kDisparityLanes)]] = std::int16_t;
  using Pairs [[gnu::vector_size(kDisparityLanes)]] = std::int32_t;
  const auto least = [](const Half& a, const Half& b)
                         __attribute__((always_inline)) { return a < b ? a : b; };
  const Half low = __builtin_shufflevector(lanes, lanes, 0, 1, 2, 3, 4, 5, 6, 7);
  const Half high = __builtin_shufflevector(lanes, lanes, 8, 9, 10, 11, 12, 13, 14, 15);
  Half v = least(low, high);
  auto pairs = reinterpret_cast<Pairs>(v);
  v = least(v, reinterpret_cast<Half>(__builtin_shufflevector(pairs, pairs, 2, 3, 0, 1)));
  pairs = reinterpret_cast<Pairs>(v);
  v = least(v, reinterpret_cast<Half>(__builtin_shufflevector(pairs, pairs, 1, 0, 3, 2)));
  pairs = reinterpret_cast<Pairs>(v);
  v = least(v, reinterpret_cast<Half>(pairs >> 16));
  return v[0];
}

/// All bits in the lanes from `first` on (0 to 16), none before: read from a table, where comparing
/// with a number would build a vector of it first.
[[gnu::always_inline]] inline Lanes lanes_from(int first) {
  static constexpr std::int16_t kSteps[2 * kDisparityLanes] = {
      0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,  0,
      -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
  return load(kSteps + kDisparityLanes - first);
}

}  // namespace hybridfusion
