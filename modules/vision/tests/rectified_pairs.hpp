#pragma once

#include "dense/semi_global_matching.hpp"
#include "dense_box_scene.hpp"

#include <cmath>
#include <cstdint>

namespace hybridfusion::testing {

inline RectifiedImages blank_pair(int width, int height, int num_disparities) {
  const int right_width = width + num_disparities - 1;
  return {.left = {width, height, 128},
          .right = {right_width, height, 128},
          .left_mask = {width, height, 255},
          .right_mask = {right_width, height, 255},
          .num_disparities = num_disparities};
}

/// A textured pair whose left pixel (x, y) has disparity index k(x, y), sampled without error.
template <class Disparity>
RectifiedImages textured_pair(int width, int height, int num_disparities, Disparity&& k) {
  RectifiedImages pair = blank_pair(width, height, num_disparities);
  const auto grey = [](double u, double v) {
    return static_cast<std::uint8_t>(std::lround(texture(u, v, 4, 4.0)));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < pair.right.width; ++x) pair.right.at(x, y) = grey(x, y);
    for (int x = 0; x < width; ++x) {
      pair.left.at(x, y) = grey(x - k(x, y) + num_disparities - 1, y);
    }
  }
  return pair;
}

}  // namespace hybridfusion::testing
