#include "stereo_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

// Vectors are passed between functions that are always inlined: no call depends on their ABI.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace hybridfusion {
namespace {

constexpr int kHalfWindow = 3;
constexpr int kWindow = 2 * kHalfWindow + 1;
constexpr int kLanes = kWindow + 1;  // a row of the window and one lane without weight
constexpr int kIterations = 2;
constexpr float kMaxShiftPx = 1.0F;   // farther, the linearisation says nothing
constexpr float kMinGradient = 4.0F;  // grey per pixel, rms over the window
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();

using Lanes [[gnu::vector_size(sizeof(float) * kLanes)]] = float;

/// Grey values of a pair as numbers. The right one's come with their central difference.
struct GreyRows {
  ImagePlane<float> left;
  ImagePlane<float> right;
  ImagePlane<float> gradient;
  int num_disparities = 0;
};

/// Slope of the disparity from the valid pixels around: windows on slanted surfaces stay aligned.
struct Slope {
  float dx = 0.0F;
  float dy = 0.0F;
};

[[gnu::always_inline]] inline Slope slope_at(const ImagePlane<float>& disparity, int x, int y) {
  constexpr float kMaxSlope = 0.5F;
  const auto along = [&](int step_x, int step_y) __attribute__((always_inline)) {
    const float before = disparity.at(x - step_x, y - step_y);
    const float after = disparity.at(x + step_x, y + step_y);
    const float slope = (after - before) / (2.0F * static_cast<float>(kHalfWindow));
    return std::abs(slope) <= kMaxSlope ? slope : 0.0F;  // also for NaN
  };
  return {along(kHalfWindow, 0), along(0, kHalfWindow)};
}

[[gnu::always_inline]] inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[gnu::always_inline]] inline float sum_of(const Lanes& v) {
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + v[3]);
}

/// Right grey values and gradients at `column` + (1 - slope) i for i = -3 .. 3.
struct Samples {
  Lanes value;
  Lanes gradient;
};

[[gnu::always_inline]] inline Samples sample_row(const float* value,
                                                 const float* gradient,
                                                 float column,
                                                 float slope) {
  constexpr Lanes kIndex = {-3, -2, -1, 0, 1, 2, 3, 4};
  // Up to here whole columns step with the window and only the fraction moves, slightly beyond the
  // interval between two pixels at the ends.
  constexpr float kMaxStep = 0.1F;
  if (std::abs(slope) <= kMaxStep) {
    const int c = static_cast<int>(column);
    const Lanes share = (column - static_cast<float>(c)) - slope * kIndex;
    const Lanes v = load(value + c - kHalfWindow);
    const Lanes g = load(gradient + c - kHalfWindow);
    return {v + share * (load(value + c - kHalfWindow + 1) - v),
            g + share * (load(gradient + c - kHalfWindow + 1) - g)};
  }
  float values[kLanes] = {};
  float gradients[kLanes] = {};
  for (int i = 0; i < kWindow; ++i) {
    const float at = column + (1.0F - slope) * static_cast<float>(i - kHalfWindow);
    const int c = static_cast<int>(at);
    const float share = at - static_cast<float>(c);
    values[i] = value[c] + share * (value[c + 1] - value[c]);
    gradients[i] = gradient[c] + share * (gradient[c + 1] - gradient[c]);
  }
  return {load(values), load(gradients)};
}

/// Gauss-Newton step of the disparity for  left = gain * right(x - d) + offset  over the window,
/// gain and offset eliminated; NaN without texture.
[[gnu::always_inline]] inline float shift_at(
    const GreyRows& grey, int x, int y, float k, const Slope& slope) {
  constexpr float kCount = kWindow * kWindow;
  constexpr Lanes kWeight = {1, 1, 1, 1, 1, 1, 1, 0};
  const float centre_column = static_cast<float>(x + grey.num_disparities - 1) - k;
  // About the values in the middle, so that the sums of squares keep their digits.
  const float left_mean = grey.left.at(x, y);
  const float right_mean = grey.right.at(static_cast<int>(centre_column), y);
  Lanes l = {}, r = {}, g = {}, rr = {}, lr = {}, lg = {}, rg = {}, gg = {};
  for (int dy = -kHalfWindow; dy <= kHalfWindow; ++dy) {
    const Samples right = sample_row(grey.right.row(y + dy),
                                     grey.gradient.row(y + dy),
                                     centre_column - slope.dy * static_cast<float>(dy),
                                     slope.dx);
    const Lanes a = (load(grey.left.row(y + dy) + x - kHalfWindow) - left_mean) * kWeight;
    const Lanes b = (right.value - right_mean) * kWeight;
    const Lanes c = right.gradient * kWeight;
    l += a;
    r += b;
    g += c;
    rr += b * b;
    lr += a * b;
    lg += a * c;
    rg += b * c;
    gg += c * c;
  }
  const float sum_l = sum_of(l);
  const float sum_r = sum_of(r);
  const float sum_g = sum_of(g);
  const float sum_gg = sum_of(gg);
  const float var_r = sum_of(rr) - sum_r * sum_r / kCount;
  const float cov_lr = sum_of(lr) - sum_l * sum_r / kCount;
  const float cov_rg = sum_of(rg) - sum_r * sum_g / kCount;
  const float cov_lg = sum_of(lg) - sum_l * sum_g / kCount;
  const float var_g = sum_gg - sum_g * sum_g / kCount;
  if (!(var_r > 1.0F) || !(sum_gg > kCount * kMinGradient * kMinGradient)) return kInvalid;
  const float gain = cov_lr / var_r;
  if (!(gain > 0.2F && gain < 5.0F)) return kInvalid;
  // d(right(x - d)) / dd = -gradient; project out the right image itself (gain).
  const float information = var_g - cov_rg * cov_rg / var_r;
  const float residual = cov_lg - gain * cov_rg;
  if (!(information > 0.1F * sum_gg)) return kInvalid;
  return -residual / (gain * information);
}

[[gnu::always_inline]] inline float refined(const GreyRows& grey,
                                            const ImagePlane<float>& disparity,
                                            int x,
                                            int y) {
  // Columns that the window may reach: half of it, stretched by the slope, and the neighbour.
  constexpr float kReach = 1.5F * kHalfWindow + 0.5F * kHalfWindow + 2.0F;
  const float start = disparity.at(x, y);
  const Slope slope = slope_at(disparity, x, y);
  const auto last_column = static_cast<float>(grey.right.width - 1);
  float k = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const float column = static_cast<float>(x + grey.num_disparities - 1) - k;
    if (!(column >= kReach && column + kReach <= last_column)) return start;
    const float shift = shift_at(grey, x, y, k, slope);
    if (!(std::abs(shift) <= kMaxShiftPx)) return start;
    k += shift;
  }
  return std::abs(k - start) <= kMaxShiftPx ? k : start;
}

__attribute__((target_clones("avx2", "default"))) void refine_row(
    const GreyRows& grey, const ImagePlane<float>& disparity, int y, float* out) {
  for (int x = kHalfWindow; x + kHalfWindow + 1 < disparity.width; ++x) {
    if (!std::isnan(disparity.at(x, y))) out[x] = refined(grey, disparity, x, y);
  }
}

GreyRows grey_rows(const RectifiedImages& images) {
  GreyRows rows{.left = {images.left.width, images.left.height},
                .right = {images.right.width, images.right.height},
                .gradient = {images.right.width, images.right.height},
                .num_disparities = images.num_disparities};
  std::ranges::copy(images.left.values, rows.left.values.begin());
  std::ranges::copy(images.right.values, rows.right.values.begin());
  for (int y = 0; y < images.right.height; ++y) {
    const float* value = rows.right.row(y);
    float* gradient = rows.gradient.row(y);
    for (int x = 1; x + 1 < images.right.width; ++x)
      gradient[x] = 0.5F * (value[x + 1] - value[x - 1]);
  }
  return rows;
}

}  // namespace

ImagePlane<float> refine_on_grey_values(const RectifiedImages& images,
                                        const ImagePlane<float>& disparity) {
  const GreyRows grey = grey_rows(images);
  ImagePlane<float> result = disparity;
  for (int y = kHalfWindow; y + kHalfWindow < disparity.height; ++y) {
    refine_row(grey, disparity, y, result.row(y));
  }
  return result;
}

}  // namespace hybridfusion
