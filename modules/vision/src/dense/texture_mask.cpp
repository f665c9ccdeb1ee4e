#include "texture_mask.hpp"

#include "census.hpp"

#include <algorithm>
#include <vector>

namespace hybridfusion {
namespace {

/// 1 where the window of the given half extents (cut at the border) is blank.
ImagePlane<std::uint8_t> blank_windows(const ImagePlane<std::uint8_t>& grey,
                                       int half_width,
                                       int half_height,
                                       double min_grey) {
  // Windows of this mean or more need the full deviation, darker ones proportionally less, down to
  // what rounding to whole grey values leaves.
  constexpr float kFullMean = 100.0F;
  constexpr float kLeastGrey = 0.7F;
  const auto limit_at = [&](float mean) {
    const auto full = static_cast<float>(min_grey);
    return std::min(full, std::max(kLeastGrey, full * mean / kFullMean));
  };
  ImagePlane<std::uint8_t> blank(grey.width, grey.height);
  // Sums down each column, moved on by one row at a time.
  std::vector<int> sum(static_cast<std::size_t>(grey.width), 0);
  std::vector<int> squares(sum.size(), 0);
  const auto add_row = [&](int y, int sign) {
    if (y < 0 || y >= grey.height) return;
    const std::uint8_t* row = grey.row(y);
    for (std::size_t x = 0; x < sum.size(); ++x) {
      sum[x] += sign * row[x];
      squares[x] += sign * row[x] * row[x];
    }
  };
  for (int y = 0; y < half_height; ++y) add_row(y, +1);
  for (int y = 0; y < grey.height; ++y) {
    add_row(y + half_height, +1);
    const int rows = std::min(grey.height, y + half_height + 1) - std::max(0, y - half_height);
    for (int x = 0; x < grey.width; ++x) {
      const int begin = std::max(0, x - half_width);
      const int end = std::min(grey.width, x + half_width + 1);
      int s = 0;
      int q = 0;
      for (int u = begin; u < end; ++u) {
        s += sum[static_cast<std::size_t>(u)];
        q += squares[static_cast<std::size_t>(u)];
      }
      const auto count = static_cast<float>(rows * (end - begin));
      const float mean = static_cast<float>(s) / count;
      const float limit = limit_at(mean);
      blank.at(x, y) = static_cast<float>(q) / count - mean * mean < limit * limit ? 1 : 0;
    }
    add_row(y - half_height, -1);
  }
  return blank;
}

/// Largest value within the given half extents along one axis.
ImagePlane<std::uint8_t> widened(const ImagePlane<std::uint8_t>& mask, int half_x, int half_y) {
  ImagePlane<std::uint8_t> result = mask;
  for (int y = 0; y < mask.height; ++y) {
    std::uint8_t* out = result.row(y);
    for (int dy = -half_y; dy <= half_y; ++dy) {
      const std::uint8_t* row = mask.row(std::clamp(y + dy, 0, mask.height - 1));
      for (int dx = -half_x; dx <= half_x; ++dx) {
        for (int x = std::max(0, -dx); x < std::min(mask.width, mask.width - dx); ++x) {
          out[x] = std::max(out[x], row[x + dx]);
        }
      }
    }
  }
  return result;
}

}  // namespace

ImagePlane<std::uint8_t> weak_texture(const ImagePlane<std::uint8_t>& grey, double min_grey) {
  ImagePlane<std::uint8_t> weak =
      blank_windows(grey, kCensusHalfWidth, kCensusHalfHeight, min_grey);
  const ImagePlane<std::uint8_t> near =
      widened(widened(weak, kCensusHalfWidth, 0), 0, kCensusHalfHeight);
  const ImagePlane<std::uint8_t> small = blank_windows(grey, 1, 1, min_grey);
  for (std::size_t i = 0; i < weak.values.size(); ++i) {
    if (near.values[i] != 0 && small.values[i] != 0) weak.values[i] = 1;
  }
  return weak;
}

}  // namespace hybridfusion
