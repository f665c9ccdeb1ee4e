#pragma once

#include <cmath>
#include <cstdint>

namespace hybridfusion {

/// Hash of a lattice point (finaliser of MurmurHash3).
[[nodiscard]] inline std::uint32_t hash_cell(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = (static_cast<std::uint32_t>(x) * 0x8da6b343U) ^
                    (static_cast<std::uint32_t>(y) * 0xd8163841U) ^ (seed * 0xcb1ab31fU);
  h ^= h >> 16U;
  h *= 0x85ebca6bU;
  h ^= h >> 13U;
  h *= 0xc2b2ae35U;
  return h ^ (h >> 16U);
}

/// Uniform in [0, 1) for a lattice point.
[[nodiscard]] inline float cell_value(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  return static_cast<float>(hash_cell(x, y, seed) >> 8U) * 0x1.0p-24F;
}

/// How much of a pattern of this wavelength survives averaging over a pixel: 1 when it is resolved,
/// 0 below two pixels a wave.
[[nodiscard]] inline float surviving(float wavelength, float footprint) {
  const float t = (wavelength / footprint - 1.5F) * 0.5F;
  return t <= 0.0F ? 0.0F : (t >= 1.0F ? 1.0F : t * t * (3.0F - 2.0F * t));
}

/// Smooth value noise in [-1, 1], lattice constant 1.
[[nodiscard]] float value_noise(float x, float y, std::uint32_t seed);

/// Sum of `octaves` of value noise, each half the wavelength and `gain` times the amplitude of the
/// one before; octaves finer than the footprint fade out. Roughly within [-1, 1].
[[nodiscard]] float fractal_noise(float x,
                                  float y,
                                  float wavelength,
                                  int octaves,
                                  float gain,
                                  std::uint32_t seed,
                                  float footprint);

/// Mean over a pixel of the 1-periodic pulse that is 1 on [0, width) and 0 elsewhere.
[[nodiscard]] float filtered_pulse(float x, float width, float footprint);

}  // namespace hybridfusion
