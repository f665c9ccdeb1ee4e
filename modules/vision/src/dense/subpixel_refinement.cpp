#include "stereo_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hybridfusion {
namespace {

constexpr int kHalfWindow = 3;
constexpr int kIterations = 2;
constexpr float kMaxShiftPx = 1.0F;   // farther, the linearisation says nothing
constexpr double kMinGradient = 4.0;  // grey per pixel, rms over the window

/// Slope of the disparity from the valid pixels around: windows on slanted surfaces stay aligned.
struct Slope {
  float dx = 0.0F;
  float dy = 0.0F;
};

Slope slope_at(const ImagePlane<float>& disparity, int x, int y) {
  constexpr float kMaxSlope = 0.5F;
  const auto along = [&](int step_x, int step_y) {
    const float before = disparity.at(x - step_x, y - step_y);
    const float after = disparity.at(x + step_x, y + step_y);
    const float slope = (after - before) / (2.0F * static_cast<float>(kHalfWindow));
    return std::abs(slope) <= kMaxSlope ? slope : 0.0F;  // also for NaN
  };
  return {along(kHalfWindow, 0), along(0, kHalfWindow)};
}

/// Sums of one window for the normal equations of  left = gain * right(x - d) + offset.
struct WindowSums {
  double n = 0, l = 0, r = 0, g = 0, ll = 0, rr = 0, lr = 0, lg = 0, rg = 0, gg = 0;

  void add(double left, double right, double gradient) {
    n += 1;
    l += left;
    r += right;
    g += gradient;
    ll += left * left;
    rr += right * right;
    lr += left * right;
    lg += left * gradient;
    rg += right * gradient;
    gg += gradient * gradient;
  }
};

/// Gauss-Newton step of the disparity with gain and offset eliminated; NaN without texture.
float shift_of(const WindowSums& s) {
  const double var_r = s.rr - s.r * s.r / s.n;
  const double cov_lr = s.lr - s.l * s.r / s.n;
  const double cov_rg = s.rg - s.r * s.g / s.n;
  const double cov_lg = s.lg - s.l * s.g / s.n;
  const double var_g = s.gg - s.g * s.g / s.n;
  if (!(var_r > 1.0) || !(s.gg > s.n * kMinGradient * kMinGradient)) {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const double gain = cov_lr / var_r;
  if (!(gain > 0.2 && gain < 5.0)) return std::numeric_limits<float>::quiet_NaN();
  // d(right(x - d)) / dd = -gradient; project out the right image itself (gain).
  const double information = var_g - cov_rg * cov_rg / var_r;
  const double residual = cov_lg - gain * cov_rg;
  if (!(information > 0.1 * s.gg)) return std::numeric_limits<float>::quiet_NaN();
  return static_cast<float>(-residual / (gain * information));
}

float refined(const RectifiedImages& images, const ImagePlane<float>& disparity, int x, int y) {
  const float start = disparity.at(x, y);
  const Slope slope = slope_at(disparity, x, y);
  float k = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    WindowSums sums;
    for (int dy = -kHalfWindow; dy <= kHalfWindow; ++dy) {
      const std::uint8_t* left = images.left.row(y + dy);
      const std::uint8_t* right = images.right.row(y + dy);
      for (int dx = -kHalfWindow; dx <= kHalfWindow; ++dx) {
        const float here =
            k + slope.dx * static_cast<float>(dx) + slope.dy * static_cast<float>(dy);
        const float column = static_cast<float>(x + dx + images.num_disparities - 1) - here;
        const int c = static_cast<int>(column);
        if (column < 1.0F || c + 2 >= images.right.width) return start;
        const float share = column - static_cast<float>(c);
        const auto grey = [right](int i) { return static_cast<float>(right[i]); };
        const float value = grey(c) + share * (grey(c + 1) - grey(c));
        // Central difference between half pixels, interpolated like the value.
        const float gradient =
            0.5F * ((1.0F - share) * (grey(c + 1) - grey(c - 1)) + share * (grey(c + 2) - grey(c)));
        sums.add(static_cast<double>(left[x + dx]), value, gradient);
      }
    }
    const float shift = shift_of(sums);
    if (!(std::abs(shift) <= kMaxShiftPx)) return start;
    k += shift;
  }
  return std::abs(k - start) <= kMaxShiftPx ? k : start;
}

}  // namespace

ImagePlane<float> refine_on_grey_values(const RectifiedImages& images,
                                        const ImagePlane<float>& disparity) {
  ImagePlane<float> result = disparity;
  for (int y = kHalfWindow; y + kHalfWindow < disparity.height; ++y) {
    for (int x = kHalfWindow; x + kHalfWindow < disparity.width; ++x) {
      if (!std::isnan(disparity.at(x, y))) result.at(x, y) = refined(images, disparity, x, y);
    }
  }
  return result;
}

}  // namespace hybridfusion
