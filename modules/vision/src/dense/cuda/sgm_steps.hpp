#pragma once

// The choice among the summed path costs, and all steps in their order. Plain C++17, as
// sgm_bodies.hpp.

#include "sgm_bodies.hpp"

#include <cmath>
#include <limits>

namespace hybridfusion::device {

/// Disparity of a right pixel: the least sum over the left pixels that may match it, the leftmost
/// of equal ones.
struct RightBody {
  SgmVolume volume;
  HF_DEVICE void operator()(std::size_t item) const {
    const SgmProblem& in = volume.in;
    const int width = volume.right_width();
    const int column = static_cast<int>(item % static_cast<std::size_t>(width));
    const std::size_t row = item / static_cast<std::size_t>(width);
    std::int16_t best = kNever;
    std::int16_t disparity = 0;
    const int first = column - (in.num_disparities - 1);
    const int last = column < in.width ? column : in.width - 1;
    for (int x = first > 0 ? first : 0; x <= last; ++x) {
      const std::size_t pixel = row * in.width + static_cast<std::size_t>(x);
      const int k = x - column + in.num_disparities - 1 - in.low[pixel];
      if (k < 0 || k >= in.count[pixel]) continue;
      const std::int16_t sum = volume.sums[volume.begin[pixel] + static_cast<std::uint64_t>(k)];
      if (sum >= best) continue;
      best = sum;
      disparity = static_cast<std::int16_t>(in.low[pixel] + k);
    }
    volume.right_disparity[item] = disparity;
  }
};

/// Disparity of a left pixel: unique, confirmed from the right, between pixels by a symmetric V. As
/// disparity_selection.cpp.
struct LeftBody {
  SgmVolume volume;

  [[nodiscard]] HF_DEVICE float winner(std::size_t pixel) const {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const int count = volume.in.count[pixel];
    const std::int16_t* sums = volume.sums + volume.begin[pixel];
    if (count < 3) return none;
    int best = 0;
    for (int k = 1; k < count; ++k) best = sums[k] < sums[best] ? k : best;
    if (best == 0 || best == count - 1) return none;
    std::int16_t second = kNever;
    for (int k = 0; k < count; ++k) {
      const bool beside = k >= best - 1 && k <= best + 1;
      if (!beside && sums[k] < second) second = sums[k];
    }
    if (second != kNever && second < (1.0 + volume.in.uniqueness) * sums[best]) return none;
    const float before = sums[best - 1];
    const float after = sums[best + 1];
    const float rise = (before > after ? before : after) - static_cast<float>(sums[best]);
    const float shift = rise > 0.0F ? 0.5F * (before - after) / rise : 0.0F;
    return static_cast<float>(volume.in.low[pixel] + best) + shift;
  }

  HF_DEVICE void operator()(std::size_t item) const {
    const SgmProblem& in = volume.in;
    const int x = static_cast<int>(item % static_cast<std::size_t>(in.width));
    const std::size_t row = item / static_cast<std::size_t>(in.width);
    float disparity = winner(item);
    if (disparity == disparity) {  // not NaN
      const int whole = static_cast<int>(std::lround(disparity));
      const int column = x - whole + in.num_disparities - 1;
      bool confirmed = column >= 0 && column < volume.right_width();
      if (confirmed) {
        const std::size_t right = row * volume.right_width() + static_cast<std::size_t>(column);
        const float gap = static_cast<float>(volume.right_disparity[right]) - disparity;
        confirmed =
            in.right_mask[right] != 0 && !((gap < 0.0F ? -gap : gap) > in.max_left_right_px + 0.5);
      }
      if (!confirmed) disparity = std::numeric_limits<float>::quiet_NaN();
    }
    volume.disparity[item] = disparity;
  }
};

/// All steps in their order. @tparam Runner  `items(n, body)` runs body(i) for i in [0, n),
/// `lines(body)` a PathBody for each of its lines; each waits for the one before.
template <class Runner>
void run_steps(Runner&& runner, const SgmVolume& volume) {
  const std::size_t left = static_cast<std::size_t>(volume.in.width) * volume.in.height;
  const std::size_t right = static_cast<std::size_t>(volume.right_width()) * volume.in.height;
  runner.items(right, CensusBody{volume});
  runner.items(left, CostBody{volume});
  for (const int sign : {+1, -1}) {
    runner.lines(PathBody{volume, sign, 0});
    runner.lines(PathBody{volume, 0, sign});
    if (!volume.in.diagonal_paths) continue;
    runner.lines(PathBody{volume, sign, sign});
    runner.lines(PathBody{volume, sign, -sign});
  }
  runner.items(right, RightBody{volume});
  runner.items(left, LeftBody{volume});
}

}  // namespace hybridfusion::device
