#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/photo.hpp>
#include <hybridfusion/core/point_cloud.hpp>
#include <hybridfusion/vision/reconstruction_options.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hybridfusion {

inline constexpr std::size_t kDescriptorSize = 128;

/// Keypoints of one photo; the vectors run in parallel.
struct FeatureSet {
  std::vector<Eigen::Vector2f> pixels = {};  ///< In the photo as stored (first centre at 0, 0).
  std::vector<Rgb8> colors = {};
  std::vector<std::uint8_t> descriptors = {};  ///< RootSIFT * 512, kDescriptorSize per keypoint.

  [[nodiscard]] std::size_t size() const { return pixels.size(); }
};

/// SIFT keypoints (Lowe 2004) with RootSIFT descriptors (Arandjelovic and Zisserman 2012), spread
/// over the photo.
/// @param image  RGB.
[[nodiscard]] Expected<FeatureSet> extract_features(const Image8& image,
                                                    const FeatureOptions& options);

}  // namespace hybridfusion
