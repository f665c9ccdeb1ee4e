#include "noise.hpp"

#include <algorithm>

namespace hybridfusion {

float value_noise(float x, float y, std::uint32_t seed) {
  const float floor_x = std::floor(x);
  const float floor_y = std::floor(y);
  const auto ix = static_cast<std::int32_t>(floor_x);
  const auto iy = static_cast<std::int32_t>(floor_y);
  const float fx = x - floor_x;
  const float fy = y - floor_y;
  const float sx = fx * fx * (3.0F - 2.0F * fx);
  const float sy = fy * fy * (3.0F - 2.0F * fy);
  const float a = cell_value(ix, iy, seed);
  const float b = cell_value(ix + 1, iy, seed);
  const float c = cell_value(ix, iy + 1, seed);
  const float d = cell_value(ix + 1, iy + 1, seed);
  const float low = a + (b - a) * sx;
  const float high = c + (d - c) * sx;
  return 2.0F * (low + (high - low) * sy) - 1.0F;
}

float fractal_noise(float x,
                    float y,
                    float wavelength,
                    int octaves,
                    float gain,
                    std::uint32_t seed,
                    float footprint) {
  float sum = 0.0F;
  float amplitude = 1.0F;
  float frequency = 1.0F / wavelength;
  for (int octave = 0; octave < octaves; ++octave) {
    const float weight = surviving(1.0F / frequency, footprint);
    if (weight <= 0.0F) break;
    // A turned lattice per octave hides the axes of the value noise.
    const float u = frequency * (0.8F * x - 0.6F * y);
    const float v = frequency * (0.6F * x + 0.8F * y);
    sum += weight * amplitude *
           (octave % 2 == 0 ? value_noise(frequency * x, frequency * y, seed + octave)
                            : value_noise(u, v, seed + octave));
    amplitude *= gain;
    frequency *= 2.0F;
  }
  return sum;
}

float filtered_pulse(float x, float width, float footprint) {
  const float half = 0.5F * std::max(footprint, 1e-4F);
  const auto integral = [width](float t) {
    const float whole = std::floor(t);
    return whole * width + std::min(t - whole, width);
  };
  return (integral(x + half) - integral(x - half)) / (2.0F * half);
}

}  // namespace hybridfusion
