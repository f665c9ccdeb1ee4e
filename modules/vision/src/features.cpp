#include "features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace hybridfusion {
namespace {

constexpr int kGridCells = 8;
constexpr int kOctaveLayers = 3;
constexpr double kSigma = 1.6;
// OpenCV before 4.8 doubles the image by bilinear interpolation about the corner of the first pixel
// but halves the coordinates about its centre: all keypoints lie 1/4 px too far right and down.
constexpr bool kDoublesAboutTheCorner =
    CV_VERSION_MAJOR < 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR < 8);
constexpr float kUpsamplingShift_px = kDoublesAboutTheCorner ? 0.25F : 0.0F;

/// Rounds of picking the strongest left in every cell until `count` are found: regions of weak
/// texture keep their share.
std::vector<std::size_t> spread_over_grid(const std::vector<cv::KeyPoint>& keypoints,
                                          const cv::Size& size,
                                          std::size_t count) {
  std::vector<std::size_t> order(keypoints.size());
  std::iota(order.begin(), order.end(), 0);
  if (keypoints.size() <= count) return order;
  std::ranges::stable_sort(
      order, std::greater<>{}, [&](std::size_t i) { return keypoints[i].response; });
  std::array<std::vector<std::size_t>, kGridCells * kGridCells> cells;
  for (const std::size_t i : order) {
    const auto cell_of = [](float at, int extent) {
      return std::clamp(
          static_cast<int>(at * kGridCells / static_cast<float>(extent)), 0, kGridCells - 1);
    };
    cells[static_cast<std::size_t>(cell_of(keypoints[i].pt.y, size.height) * kGridCells +
                                   cell_of(keypoints[i].pt.x, size.width))]
        .push_back(i);
  }
  std::size_t quota = 0;
  std::size_t kept = 0;
  while (kept < count) {
    ++quota;
    kept = 0;
    for (const auto& cell : cells) kept += std::min(cell.size(), quota);
  }
  std::vector<std::size_t> selected;
  for (const auto& cell : cells) {
    selected.insert(selected.end(),
                    cell.begin(),
                    cell.begin() + static_cast<std::ptrdiff_t>(std::min(cell.size(), quota)));
  }
  std::ranges::sort(selected);
  return selected;
}

/// Keypoints above the first contrast threshold, halved from `contrast`, that gives enough of them.
std::vector<cv::KeyPoint> detect(const cv::Mat& gray, const FeatureOptions& options) {
  std::vector<cv::KeyPoint> keypoints;
  for (double contrast = options.contrast;; contrast *= 0.5) {
    const double used = std::max(contrast, options.min_contrast);
    cv::SIFT::create(0, kOctaveLayers, used, options.edge_ratio, kSigma)->detect(gray, keypoints);
    if (static_cast<int>(keypoints.size()) >= options.min_keypoints) break;
    if (used <= options.min_contrast) break;
  }
  return keypoints;
}

void append_root_sift(const float* sift, std::vector<std::uint8_t>& out) {
  const float sum = std::accumulate(sift, sift + kDescriptorSize, 0.0F);
  for (std::size_t k = 0; k < kDescriptorSize; ++k) {
    const float root = std::sqrt(sift[k] / std::max(sum, 1e-6F));
    out.push_back(static_cast<std::uint8_t>(std::min(255.0F, std::round(512.0F * root))));
  }
}

FeatureSet extract(const Image8& image, const FeatureOptions& options) {
  // OpenCV takes the pixels without copying and does not write to them here.
  const cv::Mat rgb(image.height,
                    image.width,
                    CV_8UC3,
                    const_cast<std::uint8_t*>(image.pixels.data()));  // NOLINT
  cv::Mat gray;
  cv::cvtColor(rgb, gray, cv::COLOR_RGB2GRAY);
  const double reduction =
      std::min(1.0, options.max_size_px / static_cast<double>(std::max(gray.cols, gray.rows)));
  if (reduction < 1.0) cv::resize(gray, gray, {}, reduction, reduction, cv::INTER_AREA);

  const std::vector<cv::KeyPoint> all = detect(gray, options);
  std::vector<cv::KeyPoint> keypoints;
  for (const std::size_t i :
       spread_over_grid(all, gray.size(), static_cast<std::size_t>(options.max_keypoints))) {
    keypoints.push_back(all[i]);
  }
  cv::Mat descriptors;
  cv::SIFT::create(0, kOctaveLayers, options.min_contrast, options.edge_ratio, kSigma)
      ->compute(gray, keypoints, descriptors);

  // Not from the sizes: a side that does not divide is rounded to whole pixels, its scale is not.
  const auto scale = static_cast<float>(1.0 / reduction);
  FeatureSet features;
  features.descriptors.reserve(keypoints.size() * kDescriptorSize);
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    const cv::Point2f at = keypoints[i].pt - cv::Point2f(kUpsamplingShift_px, kUpsamplingShift_px);
    const Eigen::Vector2f pixel((at.x + 0.5F) * scale - 0.5F, (at.y + 0.5F) * scale - 0.5F);
    features.pixels.push_back(pixel);
    const auto& color =
        rgb.at<cv::Vec3b>(std::clamp(static_cast<int>(std::lround(pixel.y())), 0, rgb.rows - 1),
                          std::clamp(static_cast<int>(std::lround(pixel.x())), 0, rgb.cols - 1));
    features.colors.push_back({color[0], color[1], color[2]});
    append_root_sift(descriptors.ptr<float>(static_cast<int>(i)), features.descriptors);
  }
  return features;
}

}  // namespace

Expected<FeatureSet> extract_features(const Image8& image, const FeatureOptions& options) {
  if (image.channels != 3 || image.width < 32 || image.height < 32) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("an RGB photo of at least 32 x 32 px is needed, got {} x {} with {} "
                            "channels",
                            image.width,
                            image.height,
                            image.channels));
  }
  try {
    return extract(image, options);
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::kInsufficient,
                fmt::format("feature extraction failed: {}", error.what()));
  }
}

}  // namespace hybridfusion
