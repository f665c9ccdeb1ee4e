#include "census.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

/// The image with its border repeated, so that windows need no bounds checks.
ImagePlane<std::uint8_t> padded(const ImagePlane<std::uint8_t>& grey) {
  ImagePlane<std::uint8_t> result(grey.width + 2 * kCensusHalfWidth,
                                  grey.height + 2 * kCensusHalfHeight);
  for (int y = 0; y < result.height; ++y) {
    const std::uint8_t* source = grey.row(std::clamp(y - kCensusHalfHeight, 0, grey.height - 1));
    std::uint8_t* target = result.row(y);
    for (int x = 0; x < result.width; ++x) {
      target[x] = source[std::clamp(x - kCensusHalfWidth, 0, grey.width - 1)];
    }
  }
  return result;
}

__attribute__((target_clones("avx2", "default"))) void add_comparison(const std::uint8_t* neighbor,
                                                                      const std::uint8_t* centre,
                                                                      std::uint64_t* code,
                                                                      int count) {
  for (int x = 0; x < count; ++x) {
    code[x] = (code[x] << 1U) | static_cast<std::uint64_t>(neighbor[x] < centre[x] ? 1 : 0);
  }
}

}  // namespace

ImagePlane<std::uint64_t> census_transform(const ImagePlane<std::uint8_t>& grey) {
  const ImagePlane<std::uint8_t> source = padded(grey);
  ImagePlane<std::uint64_t> codes(grey.width, grey.height);
  for (int y = 0; y < grey.height; ++y) {
    const std::uint8_t* centre = source.row(y + kCensusHalfHeight) + kCensusHalfWidth;
    for (int dy = 0; dy <= 2 * kCensusHalfHeight; ++dy) {
      for (int dx = 0; dx <= 2 * kCensusHalfWidth; ++dx) {
        if (dy == kCensusHalfHeight && dx == kCensusHalfWidth) continue;
        add_comparison(source.row(y + dy) + dx, centre, codes.row(y), grey.width);
      }
    }
  }
  return codes;
}

ImagePlane<float> window_deviation(const ImagePlane<std::uint8_t>& grey) {
  const ImagePlane<std::uint8_t> source = padded(grey);
  constexpr int kWidth = 2 * kCensusHalfWidth + 1;
  constexpr int kHeight = 2 * kCensusHalfHeight + 1;
  ImagePlane<float> result(grey.width, grey.height);
  std::vector<int> sum(static_cast<std::size_t>(source.width));
  std::vector<int> squares(sum.size());
  for (int y = 0; y < grey.height; ++y) {
    for (int x = 0; x < source.width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      sum[i] = 0;
      squares[i] = 0;
      for (int dy = 0; dy < kHeight; ++dy) {
        const int value = source.at(x, y + dy);
        sum[i] += value;
        squares[i] += value * value;
      }
    }
    for (int x = 0; x < grey.width; ++x) {
      double s = 0.0;
      double q = 0.0;
      for (int dx = 0; dx < kWidth; ++dx) {
        s += sum[static_cast<std::size_t>(x + dx)];
        q += squares[static_cast<std::size_t>(x + dx)];
      }
      constexpr double kCount = kWidth * kHeight;
      result.at(x, y) =
          static_cast<float>(std::sqrt(std::max(0.0, q / kCount - s * s / (kCount * kCount))));
    }
  }
  return result;
}

}  // namespace hybridfusion
