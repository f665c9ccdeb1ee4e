#pragma once

#include <hybridfusion/core/options.hpp>

namespace hybridfusion {

struct FeatureOptions {
  int max_size_px = 1600;
  int min_keypoints = 4000;
  int max_keypoints = 8000;
  double contrast = 0.02;
  double min_contrast = 0.005;
  double edge_ratio = 10.0;
};
template <>
struct OptionFields<FeatureOptions> {
  using T = FeatureOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::max_size_px,
            {.key = "max_size_px",
             .unit = "px",
             .min = 200,
             .max = 20000,
             .doc = "Photos are reduced to this longest side before features are detected.",
             .source = "ours"}},
      Field{&T::min_keypoints,
            {.key = "min_keypoints",
             .unit = "1",
             .min = 50,
             .max = 100000,
             .doc = "The contrast threshold is halved until a photo has this many keypoints.",
             .source = "ours"}},
      Field{&T::max_keypoints,
            {.key = "max_keypoints",
             .unit = "1",
             .min = 100,
             .max = 100000,
             .doc = "Keypoints kept per photo, strongest first in each cell of an 8 x 8 grid.",
             .source = "ours"}},
      Field{&T::contrast,
            {.key = "contrast",
             .unit = "1",
             .min = 0.001,
             .max = 0.2,
             .doc = "First contrast threshold of the SIFT detector.",
             .source = "Lowe 2004"}},
      Field{&T::min_contrast,
            {.key = "min_contrast",
             .unit = "1",
             .min = 0.0005,
             .max = 0.2,
             .doc = "The contrast threshold is not lowered below this.",
             .source = "ours"}},
      Field{&T::edge_ratio,
            {.key = "edge_ratio",
             .unit = "1",
             .min = 2,
             .max = 100,
             .doc = "Largest ratio of principal curvatures of a keypoint.",
             .source = "Lowe 2004"}},
  };
};

struct PairOptions {
  int spatial_neighbors = 8;
  int temporal_neighbors = 3;
  int similar_neighbors = 20;
  int exhaustive_photos = 12;
};
template <>
struct OptionFields<PairOptions> {
  using T = PairOptions;
  static constexpr auto fields = std::tuple{
      Field{
          &T::spatial_neighbors,
          {.key = "spatial_neighbors",
           .unit = "photos",
           .min = 1,
           .max = 200,
           .doc = "Each photo is matched with this many nearest ones (by GNSS, and by the point on "
                  "the ground where the gimbal looks).",
           .source = "ours"}},
      Field{&T::temporal_neighbors,
            {.key = "temporal_neighbors",
             .unit = "photos",
             .min = 0,
             .max = 100,
             .doc = "Each photo is matched with this many next ones in time.",
             .source = "HybridFusion III-A.2, adjacent frames"}},
      Field{&T::similar_neighbors,
            {.key = "similar_neighbors",
             .unit = "photos",
             .min = 0,
             .max = 500,
             .doc = "In sets of more than 60, a photo without a position is matched with this many "
                    "that look most alike.",
             .source = "Jegou et al. 2010 (VLAD)"}},
      Field{&T::exhaustive_photos,
            {.key = "exhaustive_photos",
             .unit = "photos",
             .min = 2,
             .max = 500,
             .doc = "Up to this many photos, every pair is matched.",
             .source = "ours"}},
  };
};

struct MatchingOptions {
  double ratio = 0.8;
  double max_error_px = 2.0;
  int min_inliers = 20;
  double min_inlier_ratio = 0.15;
  int max_iterations = 1000;
};
template <>
struct OptionFields<MatchingOptions> {
  using T = MatchingOptions;
  static constexpr auto fields = std::tuple{
      Field{&T::ratio,
            {.key = "ratio",
             .unit = "1",
             .min = 0.1,
             .max = 1.0,
             .doc = "Largest ratio of the nearest to the second nearest descriptor distance.",
             .source = "Lowe 2004"}},
      Field{&T::max_error_px,
            {.key = "max_error_px",
             .unit = "px",
             .min = 0.1,
             .max = 50,
             .doc = "Epipolar (Sampson) error of an inlier, in pixels of the reduced photo.",
             .source = "ours"}},
      Field{&T::min_inliers,
            {.key = "min_inliers",
             .unit = "matches",
             .min = 6,
             .max = 10000,
             .doc = "A pair with fewer inliers is dropped.",
             .source = "ours"}},
      Field{&T::min_inlier_ratio,
            {.key = "min_inlier_ratio",
             .unit = "1",
             .min = 0,
             .max = 1,
             .doc = "A pair with a smaller share of inliers is dropped.",
             .source = "ours"}},
      Field{&T::max_iterations,
            {.key = "max_iterations",
             .unit = "1",
             .min = 10,
             .max = 1000000,
             .doc = "Upper bound of RANSAC samples a pair.",
             .source = "ours"}},
  };
};

}  // namespace hybridfusion
