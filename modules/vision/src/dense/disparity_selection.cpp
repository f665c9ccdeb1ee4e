#include "disparity_selection.hpp"

#include "disparity_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybridfusion {
namespace {

constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();
constexpr std::int16_t kNever = std::numeric_limits<std::int16_t>::max();

/// Sub-pixel shift between two neighbours of a minimum, for costs that rise linearly on either side
/// (census, absolute differences): a parabola would favour whole pixels.
[[gnu::always_inline]] inline float symmetric_v_offset(float before, float at, float after) {
  const float rise = std::max(before, after) - at;
  return rise > 0.0F ? 0.5F * (before - after) / rise : 0.0F;
}

/// kNever, which no bit of a sum exceeds, in the lanes of a comparison that holds; 0 elsewhere.
[[gnu::always_inline]] inline Lanes never_where(const Lanes& mask) {
  return mask & splat(kNever);
}

/// Sums of candidates k to k + 15; kNever beyond the last one.
[[gnu::always_inline]] inline Lanes candidates(const std::int16_t* sums, int k, int count) {
  const Lanes lanes = load(sums + k);
  if (k + kDisparityLanes <= count) return lanes;
  return lanes | never_where(lanes_from(count - k));
}

[[gnu::always_inline]] inline float winner(const std::int16_t* sums,
                                           int count,
                                           int low,
                                           double uniqueness) {
  if (count < 3) return kInvalid;
  Lanes least = splat(kNever);
  for (int k = 0; k < count; k += kDisparityLanes) {
    least = smaller(least, candidates(sums, k, count));
  }
  const std::int16_t at = smallest(least);
  const int best = static_cast<int>(std::find(sums, sums + count, at) - sums);
  // A minimum at the border of the candidates says only that the true one may lie beyond.
  if (best == 0 || best == count - 1) return kInvalid;
  Lanes others = splat(kNever);
  for (int k = 0; k < count; k += kDisparityLanes) {
    const Lanes beside = lanes_from(std::clamp(best - 1 - k, 0, kDisparityLanes)) &
                         ~lanes_from(std::clamp(best + 2 - k, 0, kDisparityLanes));
    others = smaller(others, candidates(sums, k, count) | never_where(beside));
  }
  const std::int16_t second = smallest(others);
  if (second != kNever && second < (1.0 + uniqueness) * at) return kInvalid;
  return static_cast<float>(low + best) + symmetric_v_offset(sums[best - 1], at, sums[best + 1]);
}

__attribute__((target_clones("avx2", "default"))) void winners(const CandidateRow& row,
                                                               double uniqueness,
                                                               float* disparity) {
  for (int x = 0; x < row.width; ++x) {
    const std::int16_t* sums = row.sums + static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
    disparity[x] = winner(sums, row.count[x], row.low[x], uniqueness);
  }
}

/// Best cost and disparity of each right column over the left pixels that may match it.
__attribute__((target_clones("avx2", "default"))) void right_winners(const CandidateRow& row,
                                                                     std::int16_t* cost,
                                                                     std::int16_t* disparity) {
  for (int x = 0; x < row.width; ++x) {
    const std::int16_t* sums = row.sums + static_cast<std::size_t>(row.block[x]) * kDisparityLanes;
    const std::int16_t low = row.low[x];
    const int start = row.width - 1 - x + low;
    const int count = row.count[x];
    for (int k = 0; k < count; ++k) {
      const bool better = sums[k] < cost[start + k];
      cost[start + k] = better ? sums[k] : cost[start + k];
      disparity[start + k] = better ? static_cast<std::int16_t>(low + k) : disparity[start + k];
    }
  }
}

}  // namespace

DisparitySelection::DisparitySelection(const RectifiedImages& images, const StereoOptions& options)
    : images_(images),
      options_(options),
      right_cost_(static_cast<std::size_t>(images.right.width)),
      right_disparity_(right_cost_.size()) {}

void DisparitySelection::select(const CandidateRow& row, int y, float* disparity) {
  std::ranges::fill(right_cost_, kNever);
  right_winners(row, right_cost_.data(), right_disparity_.data());
  winners(row, options_.uniqueness, disparity);
  const std::uint8_t* right_mask = images_.right_mask.row(y);
  for (int x = 0; x < row.width; ++x) {
    if (std::isnan(disparity[x])) continue;
    const int column =
        x - static_cast<int>(std::lround(disparity[x])) + images_.num_disparities - 1;
    const bool seen = column >= 0 && column < images_.right.width && right_mask[column] != 0;
    const auto from_right = static_cast<std::size_t>(images_.right.width - 1 - column);
    if (!seen || std::abs(static_cast<float>(right_disparity_[from_right]) - disparity[x]) >
                     options_.max_left_right_px + 0.5) {
      disparity[x] = kInvalid;
    }
  }
}

}  // namespace hybridfusion
