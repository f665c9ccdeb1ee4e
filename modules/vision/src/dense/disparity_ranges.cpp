#include "semi_global_matching.hpp"

#include <algorithm>
#include <cmath>

namespace hybridfusion {
namespace {

constexpr int kWindow = 2;  // coarse pixels around: both sides of an edge stay candidates
constexpr int kMargin = 3;  // fine disparities beyond what the coarse level found
constexpr int kMinCandidates = 7;
constexpr int kUnknown = -1;

/// Lowest and highest disparity index known near each coarse pixel; kUnknown where none is.
struct Span {
  ImagePlane<int> low;
  ImagePlane<int> high;
};

void merge(int& low, int& high, int other_low, int other_high) {
  if (other_low == kUnknown) return;
  low = low == kUnknown ? other_low : std::min(low, other_low);
  high = high == kUnknown ? other_high : std::max(high, other_high);
}

/// Each pixel's span merged with those up to kWindow away along one axis.
Span widened(const Span& known, int step_x, int step_y) {
  Span result = known;
  const int width = known.low.width;
  const int height = known.low.height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int i = -kWindow; i <= kWindow; ++i) {
        const int u = std::clamp(x + i * step_x, 0, width - 1);
        const int v = std::clamp(y + i * step_y, 0, height - 1);
        merge(result.low.at(x, y), result.high.at(x, y), known.low.at(u, v), known.high.at(u, v));
      }
    }
  }
  return result;
}

Span spans_of(const ImagePlane<float>& coarse) {
  Span known{.low = {coarse.width, coarse.height, kUnknown},
             .high = {coarse.width, coarse.height, kUnknown}};
  for (std::size_t i = 0; i < coarse.values.size(); ++i) {
    if (std::isnan(coarse.values[i])) continue;
    known.low.values[i] = static_cast<int>(std::floor(coarse.values[i]));
    known.high.values[i] = static_cast<int>(std::ceil(coarse.values[i]));
  }
  return widened(widened(known, 1, 0), 0, 1);
}

/// Gives an unknown pixel the span of the nearest known ones along a line.
void fill_line(Span& span, int x, int y, int step_x, int step_y, int count) {
  const auto sweep = [&](int first, int direction, std::vector<std::pair<int, int>>& seen) {
    std::pair<int, int> last{kUnknown, kUnknown};
    for (int i = 0; i < count; ++i) {
      const int k = first + direction * i;
      const int u = x + k * step_x;
      const int v = y + k * step_y;
      if (span.low.at(u, v) != kUnknown) last = {span.low.at(u, v), span.high.at(u, v)};
      seen[static_cast<std::size_t>(k)] = last;
    }
  };
  std::vector<std::pair<int, int>> before(static_cast<std::size_t>(count));
  std::vector<std::pair<int, int>> after(before.size());
  sweep(0, +1, before);
  sweep(count - 1, -1, after);
  for (int k = 0; k < count; ++k) {
    int& low = span.low.at(x + k * step_x, y + k * step_y);
    int& high = span.high.at(x + k * step_x, y + k * step_y);
    if (low != kUnknown) continue;
    const auto i = static_cast<std::size_t>(k);
    merge(low, high, before[i].first, before[i].second);
    merge(low, high, after[i].first, after[i].second);
  }
}

}  // namespace

DisparityRanges ranges_around(const ImagePlane<float>& coarse, const RectifiedImages& images) {
  Span span = spans_of(coarse);
  for (int y = 0; y < coarse.height; ++y) fill_line(span, 0, y, 1, 0, coarse.width);
  for (int x = 0; x < coarse.width; ++x) fill_line(span, x, 0, 0, 1, coarse.height);

  DisparityRanges ranges = full_ranges(images);
  for (int y = 0; y < images.left.height; ++y) {
    for (int x = 0; x < images.left.width; ++x) {
      if (ranges.count.at(x, y) == 0) continue;
      const int u = std::min(x / 2, coarse.width - 1);
      const int v = std::min(y / 2, coarse.height - 1);
      if (span.low.at(u, v) == kUnknown) continue;  // nothing known anywhere: all disparities
      int low = 2 * span.low.at(u, v) - kMargin;
      int end = 2 * span.high.at(u, v) + kMargin + 1;
      if (end - low < kMinCandidates) end = low + kMinCandidates;
      low = std::clamp(low, 0, std::max(0, images.num_disparities - kMinCandidates));
      end = std::clamp(end, low + 1, images.num_disparities);
      ranges.low.at(x, y) = static_cast<std::int16_t>(low);
      ranges.count.at(x, y) = static_cast<std::int16_t>(end - low);
    }
  }
  return ranges;
}

}  // namespace hybridfusion
