#include "semi_global_matching.hpp"

#include "census.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace hybridfusion {
namespace {

constexpr std::uint8_t kNoDataCost = 31;        // half of the bits: as good as chance
constexpr std::uint16_t kUnreachable = 0x3fff;  // leaves room for penalties in 16 bits
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();

__attribute__((target_clones("popcnt", "default"))) void hamming_costs(std::uint64_t left,
                                                                       const std::uint64_t* right,
                                                                       const std::uint8_t* mask,
                                                                       int count,
                                                                       std::uint8_t* cost) {
  for (int k = 0; k < count; ++k) {
    const auto bits = static_cast<std::uint8_t>(std::popcount(left ^ right[k]));
    cost[k] = mask[k] != 0 ? bits : kNoDataCost;
  }
}

struct PathStep {
  const std::uint8_t* cost;
  const std::uint16_t* previous;  // previous costs at low - 1 .. low + count
  std::uint16_t previous_min;
  std::uint16_t small;  // P1
  std::uint16_t large;  // P2, already adapted to the grey edge
};

/// L(p, d) = C(p, d) + min(L(q, d), L(q, d +- 1) + P1, min L(q) + P2) - min L(q)
/// (Hirschmueller 2008, Eq. 13). Adds L to `sum`. @returns min over d of L(p, d).
__attribute__((target_clones("avx2", "default"))) std::uint16_t advance_path(const PathStep& step,
                                                                             int count,
                                                                             std::uint16_t* out,
                                                                             std::uint16_t* sum) {
  const auto jump = static_cast<std::uint16_t>(step.previous_min + step.large);
  const std::uint16_t* previous = step.previous;
  std::uint16_t best = std::numeric_limits<std::uint16_t>::max();
  for (int k = 0; k < count; ++k) {
    const auto down = static_cast<std::uint16_t>(previous[k] + step.small);
    const auto up = static_cast<std::uint16_t>(previous[k + 2] + step.small);
    const std::uint16_t stay = std::min(previous[k + 1], jump);
    const std::uint16_t least = std::min(stay, std::min(down, up));
    const auto value = static_cast<std::uint16_t>(step.cost[k] + least - step.previous_min);
    out[k] = value;
    sum[k] = static_cast<std::uint16_t>(sum[k] + value);
    best = std::min(best, value);
  }
  return best;
}

/// Path costs of one pixel, kept for its successor.
struct PathState {
  std::vector<std::uint16_t> costs = {};
  int low = 0;
  int count = 0;
  std::uint16_t min = 0;
};

/// The whole matching of one image pair: costs and sums of all pixels lie behind one another, as
/// many for each pixel as it has candidates.
class Matcher {
 public:
  Matcher(const RectifiedImages& images,
          const DisparityRanges& ranges,
          const StereoOptions& options);
  void aggregate();
  [[nodiscard]] ImagePlane<float> select() const;

 private:
  [[nodiscard]] std::uint16_t* sums(int x, int y) { return sums_.data() + first_[pixel(x, y)]; }
  [[nodiscard]] std::size_t pixel(int x, int y) const { return ranges_.low.offset(x, y); }
  [[nodiscard]] std::uint16_t large_penalty(int x, int y, int from_x, int from_y) const;
  void compute_costs();
  void aggregate_pass(int step);
  void advance(int x, int y, int from_x, int from_y, const PathState& from, PathState& to);
  [[nodiscard]] float winner(int x, int y) const;

  const RectifiedImages& images_;
  const DisparityRanges& ranges_;
  const StereoOptions& options_;
  std::vector<std::size_t> first_;  // of each pixel, into costs_ and sums_
  std::vector<std::uint8_t> costs_;
  std::vector<std::uint16_t> sums_;
  std::vector<std::uint16_t> shifted_;  // scratch of advance()
};

Matcher::Matcher(const RectifiedImages& images,
                 const DisparityRanges& ranges,
                 const StereoOptions& options)
    : images_(images), ranges_(ranges), options_(options) {
  const std::size_t num_pixels = ranges.low.values.size();
  first_.resize(num_pixels + 1, 0);
  for (std::size_t i = 0; i < num_pixels; ++i) {
    first_[i + 1] = first_[i] + static_cast<std::size_t>(ranges.count.values[i]);
  }
  costs_.resize(first_.back());
  sums_.assign(first_.back(), 0);
  shifted_.resize(static_cast<std::size_t>(images.num_disparities) + 2);
  compute_costs();
}

void Matcher::compute_costs() {
  const ImagePlane<std::uint64_t> left = census_transform(images_.left);
  const ImagePlane<std::uint64_t> right = census_transform(images_.right);
  // Right rows run backwards, so that rising disparities read forwards.
  std::vector<std::uint64_t> codes(static_cast<std::size_t>(right.width));
  std::vector<std::uint8_t> mask(codes.size());
  for (int y = 0; y < left.height; ++y) {
    std::reverse_copy(right.row(y), right.row(y) + right.width, codes.begin());
    std::reverse_copy(
        images_.right_mask.row(y), images_.right_mask.row(y) + right.width, mask.begin());
    for (int x = 0; x < left.width; ++x) {
      const std::size_t i = pixel(x, y);
      const int start = left.width - 1 - x + ranges_.low.values[i];
      hamming_costs(left.values[i],
                    codes.data() + start,
                    mask.data() + start,
                    ranges_.count.values[i],
                    costs_.data() + first_[i]);
    }
  }
}

std::uint16_t Matcher::large_penalty(int x, int y, int from_x, int from_y) const {
  const int step = std::abs(images_.left.at(x, y) - images_.left.at(from_x, from_y));
  return static_cast<std::uint16_t>(
      std::max(options_.smoothness_small + 1, options_.smoothness_large * 16 / (16 + step)));
}

void Matcher::advance(int x, int y, int from_x, int from_y, const PathState& from, PathState& to) {
  const std::size_t i = pixel(x, y);
  to.low = ranges_.low.values[i];
  to.count = ranges_.count.values[i];
  to.costs.resize(static_cast<std::size_t>(to.count));
  if (to.count == 0) return;
  const auto needed = static_cast<std::size_t>(to.count) + 2;
  std::fill_n(shifted_.begin(), needed, from.count == 0 ? std::uint16_t{0} : kUnreachable);
  const int begin = std::max(from.low, to.low - 1);
  const int end = std::min(from.low + from.count, to.low + to.count + 1);
  if (begin < end) {
    std::copy(from.costs.begin() + (begin - from.low),
              from.costs.begin() + (end - from.low),
              shifted_.begin() + (begin - to.low + 1));
  }
  const PathStep step{.cost = costs_.data() + first_[i],
                      .previous = shifted_.data(),
                      .previous_min = from.count == 0 ? std::uint16_t{0} : from.min,
                      .small = static_cast<std::uint16_t>(options_.smoothness_small),
                      .large = large_penalty(x, y, from_x, from_y)};
  to.min = advance_path(step, to.count, to.costs.data(), sums(x, y));
}

/// step +1: paths from the left and from above; -1: from the right and from below.
void Matcher::aggregate_pass(int step) {
  const int width = images_.left.width;
  const int height = images_.left.height;
  std::vector<PathState> vertical(static_cast<std::size_t>(width));
  PathState horizontal;
  PathState next;
  for (int row = 0; row < height; ++row) {
    const int y = step > 0 ? row : height - 1 - row;
    const int from_y = std::clamp(y - step, 0, height - 1);
    horizontal.count = 0;
    for (int column = 0; column < width; ++column) {
      const int x = step > 0 ? column : width - 1 - column;
      const int from_x = std::clamp(x - step, 0, width - 1);
      advance(x, y, from_x, y, horizontal, next);
      std::swap(horizontal, next);
      advance(x, y, x, from_y, vertical[static_cast<std::size_t>(x)], next);
      std::swap(vertical[static_cast<std::size_t>(x)], next);
    }
  }
}

void Matcher::aggregate() {
  aggregate_pass(+1);
  aggregate_pass(-1);
}

/// Sub-pixel shift between two neighbours of a minimum, for costs that rise linearly on either side
/// (census, absolute differences): a parabola would favour whole pixels.
float symmetric_v_offset(float before, float at, float after) {
  const float rise = std::max(before, after) - at;
  return rise > 0.0F ? 0.5F * (before - after) / rise : 0.0F;
}

float Matcher::winner(int x, int y) const {
  const std::size_t i = pixel(x, y);
  const int count = ranges_.count.values[i];
  if (count < 3) return kInvalid;
  const std::uint16_t* sum = sums_.data() + first_[i];
  const int best = static_cast<int>(std::min_element(sum, sum + count) - sum);
  // A minimum at the border of the candidates says only that the true one may lie beyond.
  if (best == 0 || best == count - 1) return kInvalid;
  std::uint16_t second = std::numeric_limits<std::uint16_t>::max();
  for (int k = 0; k < count; ++k) {
    if (std::abs(k - best) > 1) second = std::min(second, sum[k]);
  }
  if (second < (1.0 + options_.uniqueness) * sum[best]) return kInvalid;
  return static_cast<float>(ranges_.low.values[i] + best) +
         symmetric_v_offset(sum[best - 1], sum[best], sum[best + 1]);
}

ImagePlane<float> Matcher::select() const {
  const int width = images_.left.width;
  ImagePlane<float> result(width, images_.left.height, kInvalid);
  const auto right_width = static_cast<std::size_t>(images_.right.width);
  std::vector<std::uint16_t> right_cost(right_width);
  std::vector<int> right_disparity(right_width);
  for (int y = 0; y < result.height; ++y) {
    std::ranges::fill(right_cost, std::numeric_limits<std::uint16_t>::max());
    for (int x = 0; x < width; ++x) {
      const std::size_t i = pixel(x, y);
      const int low = ranges_.low.values[i];
      for (int k = low; k < low + ranges_.count.values[i]; ++k) {
        const auto column = static_cast<std::size_t>(x - k + images_.num_disparities - 1);
        const std::uint16_t sum = sums_[first_[i] + static_cast<std::size_t>(k - low)];
        if (sum < right_cost[column]) {
          right_cost[column] = sum;
          right_disparity[column] = k;
        }
      }
    }
    for (int x = 0; x < width; ++x) {
      const float k = winner(x, y);
      if (std::isnan(k)) continue;
      const auto column =
          static_cast<std::size_t>(x - std::lround(k) + images_.num_disparities - 1);
      if (column >= right_width || images_.right_mask.at(static_cast<int>(column), y) == 0)
        continue;
      if (std::abs(static_cast<float>(right_disparity[column]) - k) >
          options_.max_left_right_px + 0.5)
        continue;
      result.at(x, y) = k;
    }
  }
  return result;
}

}  // namespace

DisparityRanges full_ranges(const RectifiedImages& images) {
  DisparityRanges ranges{.low = {images.left.width, images.left.height, 0},
                         .count = {images.left.width, images.left.height, 0}};
  for (std::size_t i = 0; i < ranges.count.values.size(); ++i) {
    if (images.left_mask.values[i] != 0) {
      ranges.count.values[i] = static_cast<std::int16_t>(images.num_disparities);
    }
  }
  return ranges;
}

ImagePlane<float> match_semi_globally(const RectifiedImages& images,
                                      const DisparityRanges& ranges,
                                      const StereoOptions& options) {
  Matcher matcher(images, ranges, options);
  matcher.aggregate();
  return matcher.select();
}

}  // namespace hybridfusion
