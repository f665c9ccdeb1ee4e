#include "stereo_matcher.hpp"

#include "texture_mask.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

namespace hybridfusion {
namespace {

constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();
// Matching a quarter of the pixels over that many is cheap, and a still coarser level would lose
// narrow surfaces.
constexpr int kMinCoarseDisparities = 48;
constexpr int kMinCoarseWidth = 160;

ImagePlane<std::uint8_t> half_grey(const ImagePlane<std::uint8_t>& image) {
  ImagePlane<std::uint8_t> half(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const int sum = image.at(2 * x, 2 * y) + image.at(2 * x + 1, 2 * y) +
                      image.at(2 * x, 2 * y + 1) + image.at(2 * x + 1, 2 * y + 1);
      half.at(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return half;
}

ImagePlane<std::uint8_t> half_mask(const ImagePlane<std::uint8_t>& mask) {
  ImagePlane<std::uint8_t> half(mask.width / 2, mask.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      half.at(x, y) = std::min(std::min(mask.at(2 * x, 2 * y), mask.at(2 * x + 1, 2 * y)),
                               std::min(mask.at(2 * x, 2 * y + 1), mask.at(2 * x + 1, 2 * y + 1)));
    }
  }
  return half;
}

ImagePlane<float> match_level(const RectifiedImages& images,
                              const DisparityRanges& ranges,
                              const StereoOptions& options,
                              DeviceMatcher* device) {
  if (device != nullptr) {
    if (auto disparity = device->match(images, ranges, options)) return *std::move(disparity);
  }
  return match_semi_globally(images, ranges, options);
}

/// Full range at the coarsest level, then a few candidates around it at each finer one
/// (Rothermel et al. 2012): the cost grows with the image, not with the depth range.
ImagePlane<float> match_coarse_to_fine(const RectifiedImages& images,
                                       const StereoOptions& options,
                                       DeviceMatcher* device) {
  const bool coarse_enough = images.num_disparities % 2 == 0 ||
                             images.num_disparities / 2 < kMinCoarseDisparities ||
                             images.left.width / 2 < kMinCoarseWidth;
  if (coarse_enough) return match_level(images, full_ranges(images), options, device);
  const ImagePlane<float> coarse = match_coarse_to_fine(half_size(images), options, device);
  return match_level(images, ranges_around(coarse, images), options, device);
}

/// OpenCV wants images of one size with x_right = x_left - d: the left image moves into a frame as
/// wide as the right one.
ImagePlane<float> match_with_opencv(const RectifiedImages& images, const StereoOptions& options) {
  const int shift = images.num_disparities - 1;
  const int num_disparities = (images.num_disparities + 15) / 16 * 16;
  const cv::Size size(images.right.width, images.right.height);
  const cv::Mat right(size, CV_8UC1, const_cast<std::uint8_t*>(images.right.values.data()));
  cv::Mat left(size, CV_8UC1, cv::Scalar(0));
  const cv::Mat narrow(images.left.height,
                       images.left.width,
                       CV_8UC1,
                       const_cast<std::uint8_t*>(images.left.values.data()));
  narrow.copyTo(left(cv::Rect(shift, 0, narrow.cols, narrow.rows)));
  constexpr int kBlock = 5;
  const auto matcher =
      cv::StereoSGBM::create(0,
                             num_disparities,
                             kBlock,
                             8 * kBlock * kBlock,
                             32 * kBlock * kBlock,
                             static_cast<int>(std::ceil(options.max_left_right_px)),
                             63,
                             static_cast<int>(100.0 * options.uniqueness),
                             0,
                             0,
                             cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat sixteenths;
  matcher->compute(left, right, sixteenths);
  ImagePlane<float> result(images.left.width, images.left.height, kInvalid);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const auto value = sixteenths.at<std::int16_t>(y, x + shift);
      if (value >= 0 && images.left_mask.at(x, y) != 0) {
        result.at(x, y) = static_cast<float>(value) / 16.0F;
      }
    }
  }
  return result;
}

void remove_weak_texture(const RectifiedImages& images,
                         double min_grey,
                         ImagePlane<float>& disparity) {
  const ImagePlane<std::uint8_t> weak = weak_texture(images.left, min_grey);
  for (std::size_t i = 0; i < disparity.values.size(); ++i) {
    if (weak.values[i] != 0) disparity.values[i] = kInvalid;
  }
}

}  // namespace

RectifiedImages half_size(const RectifiedImages& images) {
  return {.left = half_grey(images.left),
          .right = half_grey(images.right),
          .left_mask = half_mask(images.left_mask),
          .right_mask = half_mask(images.right_mask),
          .num_disparities = (images.num_disparities - 1) / 2 + 1};
}

namespace {

/// Median of each 3 x 3 neighbourhood of a row (Smith 1996, exchange network); NaN or arbitrary
/// where one of the nine is NaN.
__attribute__((target_clones("avx2", "default"))) void median_row(
    const float* above, const float* at, const float* below, float* out, int width) {
  for (int x = 1; x + 1 < width; ++x) {
    float a = above[x - 1];
    float b = above[x];
    float c = above[x + 1];
    float d = at[x - 1];
    float e = at[x];
    float f = at[x + 1];
    float g = below[x - 1];
    float h = below[x];
    float i = below[x + 1];
    const auto order = [](float& low, float& high) __attribute__((always_inline)) {
      const float smaller = low < high ? low : high;
      high = low < high ? high : low;
      low = smaller;
    };
    order(b, c), order(e, f), order(h, i);
    order(a, b), order(d, e), order(g, h);
    order(b, c), order(e, f), order(h, i);
    order(a, d), order(f, i), order(e, h);
    order(d, g), order(b, e), order(c, f);
    order(e, h), order(e, c), order(g, e);
    order(e, c);
    out[x] = e;
  }
}

/// Median of the valid values among the nine around (x, y); the centre's when few are valid.
float median_of_valid(const ImagePlane<float>& disparity, int x, int y) {
  std::array<float, 9> values{};
  std::size_t count = 0;
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      if (!std::isnan(disparity.at(u, v))) values[count++] = disparity.at(u, v);
    }
  }
  if (count < 5) return disparity.at(x, y);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

}  // namespace

ImagePlane<float> median_filtered(const ImagePlane<float>& disparity) {
  ImagePlane<float> result = disparity;
  const int width = disparity.width;
  std::vector<float> medians(static_cast<std::size_t>(width));
  for (int y = 1; y + 1 < disparity.height; ++y) {
    const float* above = disparity.row(y - 1);
    const float* at = disparity.row(y);
    const float* below = disparity.row(y + 1);
    median_row(above, at, below, medians.data(), width);
    for (int x = 1; x + 1 < width; ++x) {
      if (std::isnan(at[x])) continue;
      float sum = 0.0F;
      for (int u = x - 1; u <= x + 1; ++u) sum += above[u] + at[u] + below[u];
      result.at(x, y) =
          std::isnan(sum) ? median_of_valid(disparity, x, y) : medians[static_cast<std::size_t>(x)];
    }
  }
  return result;
}

void remove_small_segments(ImagePlane<float>& disparity, int min_segment_px) {
  constexpr float kMaxStep = 1.0F;
  std::vector<std::uint8_t> visited(disparity.values.size(), 0);
  std::vector<std::size_t> segment;
  const auto width = static_cast<std::size_t>(disparity.width);
  for (std::size_t seed = 0; seed < disparity.values.size(); ++seed) {
    if (visited[seed] != 0 || std::isnan(disparity.values[seed])) continue;
    segment.assign(1, seed);
    visited[seed] = 1;
    for (std::size_t next = 0; next < segment.size(); ++next) {
      const std::size_t i = segment[next];
      const auto visit = [&](std::size_t j) {
        // False for NaN.
        if (visited[j] == 0 && std::abs(disparity.values[j] - disparity.values[i]) <= kMaxStep) {
          visited[j] = 1;
          segment.push_back(j);
        }
      };
      if (i % width > 0) visit(i - 1);
      if (i % width + 1 < width) visit(i + 1);
      if (i >= width) visit(i - width);
      if (i + width < disparity.values.size()) visit(i + width);
    }
    if (segment.size() < static_cast<std::size_t>(min_segment_px)) {
      for (const std::size_t i : segment) disparity.values[i] = kInvalid;
    }
  }
}

Expected<ImagePlane<float>> match_pair(const RectifiedImages& images,
                                       const StereoOptions& options,
                                       DeviceMatcher* device) {
  ImagePlane<float> disparity;
  if (options.matcher == "sgbm") {
    try {
      disparity = match_with_opencv(images, options);
    } catch (const cv::Exception& e) {
      return fail(ErrorCode::kInsufficient,
                  std::string("OpenCV's stereo matcher failed: ") + e.what());
    }
  } else {
    disparity = match_coarse_to_fine(images, options, device);
  }
  remove_weak_texture(images, options.min_texture_grey, disparity);
  remove_small_segments(disparity, options.min_segment_px);
  return refine_on_grey_values(images, median_filtered(disparity));
}

}  // namespace hybridfusion
