#include "dense/stereo_matcher.hpp"
#include "dense/texture_mask.hpp"
#include "rectified_pairs.hpp"

#include <hybridfusion/core/random.hpp>

#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Grey = ImagePlane<std::uint8_t>;
using testing::blank_pair;
using testing::textured_pair;

TEST(StereoMatcher, FindsSubpixelDisparitiesOnASlantedSurface) {
  const auto k = [](int x, int y) { return 12.3 + 0.02 * x - 0.03 * y; };
  const RectifiedImages pair = textured_pair(200, 90, 33, k);
  const auto found = match_pair(pair, {});
  ASSERT_TRUE(found);
  std::vector<double> errors;
  for (int y = 5; y < 85; ++y) {
    for (int x = 5; x < 195; ++x) {
      if (!std::isnan(found->at(x, y))) errors.push_back(std::abs(found->at(x, y) - k(x, y)));
    }
  }
  ASSERT_GT(errors.size(), 0.97 * 80 * 190);
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.03);  // grey values are rounded: 0.01 to 0.02 px
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.12);
}

TEST(StereoMatcher, OpenCvMatcherCountsDisparitiesTheSameWay) {
  const auto k = [](int, int) { return 11.4; };
  const auto found = match_pair(textured_pair(160, 80, 33, k), {.matcher = "sgbm"});
  ASSERT_TRUE(found);
  int valid = 0;
  for (int y = 10; y < 70; ++y) {
    for (int x = 10; x < 150; ++x) {
      if (std::isnan(found->at(x, y))) continue;
      EXPECT_NEAR(found->at(x, y), 11.4, 0.3);
      ++valid;
    }
  }
  EXPECT_GT(valid, 0.9 * 60 * 140);
}

/// A square in front of a wall; what the right image cannot see is right of the square's left edge
/// in neither image, so nothing may be claimed there but one of the two surfaces.
RectifiedImages occluding_pair(double wall, double square) {
  RectifiedImages pair = blank_pair(240, 80, 41);
  const auto in_square = [](double x, int y) { return x >= 90 && x < 150 && y >= 20 && y < 60; };
  const auto grey = [](double u, int v, int layer) {
    return static_cast<std::uint8_t>(std::lround(testing::texture(u, v, layer, 4.0)));
  };
  for (int y = 0; y < pair.left.height; ++y) {
    for (int x = 0; x < pair.left.width; ++x) {
      pair.left.at(x, y) = in_square(x, y) ? grey(x, y, 7) : grey(x, y, 4);
    }
    for (int c = 0; c < pair.right.width; ++c) {
      const double on_square = c + square - 40;
      pair.right.at(c, y) =
          in_square(on_square, y) ? grey(on_square, y, 7) : grey(c + wall - 40, y, 4);
    }
  }
  return pair;
}

TEST(StereoMatcher, LeavesOutWhatOnlyOneImageSees) {
  const RectifiedImages pair = occluding_pair(8.0, 24.0);
  const auto found = match_pair(pair, {.min_segment_px = 20});
  ASSERT_TRUE(found);
  int claimed = 0;
  int wrong = 0;
  for (int y = 26; y < 54; ++y) {
    // The square hides 16 columns of the wall left of it from the right image.
    for (int x = 90 - 16 + 3; x < 90 - 4; ++x) claimed += std::isnan(found->at(x, y)) ? 0 : 1;
    for (int x = 100; x < 140; ++x) {
      wrong += std::abs(found->at(x, y) - 24.0) < 0.3 ? 0 : 1;
    }
    for (int x = 165; x < 220; ++x) {
      wrong += std::abs(found->at(x, y) - 8.0) < 0.3 ? 0 : 1;
    }
  }
  EXPECT_LT(claimed, 0.1 * 28 * 9);
  EXPECT_EQ(wrong, 0);
}

TEST(StereoMatcher, CoarseToFineFindsWhatTheFullRangeFinds) {
  const auto k = [](int x, int y) { return 40.0 + 0.05 * x + 4.0 * std::sin(0.05 * y); };
  const RectifiedImages pair = textured_pair(360, 120, 97, k);
  const auto coarse_to_fine = match_pair(pair, {});
  ASSERT_TRUE(coarse_to_fine);
  const ImagePlane<float> full = match_semi_globally(pair, full_ranges(pair), {});
  int valid = 0;
  int same = 0;
  for (std::size_t i = 0; i < full.values.size(); ++i) {
    if (std::isnan(full.values[i])) continue;
    ++valid;
    same += std::abs(full.values[i] - coarse_to_fine->values[i]) < 1.0F ? 1 : 0;
  }
  EXPECT_GT(valid, 0.9 * 360 * 120);
  EXPECT_GT(same, 0.97 * valid);
}

TEST(StereoMatcher, ABlankSkyAndPixelsWithoutDataGetNoDisparity) {
  RectifiedImages pair = textured_pair(200, 100, 33, [](int, int) { return 15.0; });
  for (int y = 0; y < 40; ++y) {
    std::fill_n(pair.left.row(y), pair.left.width, std::uint8_t{210});
    std::fill_n(pair.right.row(y), pair.right.width, std::uint8_t{210});
  }
  for (int y = 40; y < 100; ++y) std::fill_n(pair.left_mask.row(y) + 150, 50, std::uint8_t{0});
  for (const char* matcher : {"sgm", "sgbm"}) {
    const auto found = match_pair(pair, {.matcher = matcher});
    ASSERT_TRUE(found);
    int sky = 0;
    int outside = 0;
    int inside = 0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (std::isnan(found->at(x, y))) continue;
        sky += y < 39 ? 1 : 0;  // no window of the blank part takes the wall's disparity
        outside += y >= 40 && x >= 150 ? 1 : 0;
        inside += y >= 50 && y < 90 && x >= 10 && x < 140 ? 1 : 0;
      }
    }
    EXPECT_EQ(sky, 0) << matcher;
    EXPECT_EQ(outside, 0) << matcher;
    EXPECT_GT(inside, 0.95 * 40 * 130) << matcher;
  }
}

TEST(WeakTexture, ShadowNeedsLessContrastThanLightAndBlankIsWeakInBoth) {
  Grey grey(60, 30, 20);
  Random random(3, "shadow");
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 60; ++x) {
      const int noise = static_cast<int>(random.index(5)) - 2;  // deviation 1.4
      if (x < 20) grey.at(x, y) = static_cast<std::uint8_t>(40 + noise);
      if (x >= 20 && x < 40) grey.at(x, y) = static_cast<std::uint8_t>(180 + noise);
    }
  }
  const auto weak = weak_texture(grey, 2.0);
  for (int y = 5; y < 25; ++y) {
    for (int x = 5; x < 15; ++x) EXPECT_EQ(weak.at(x, y), 0);
    for (int x = 25; x < 35; ++x) EXPECT_EQ(weak.at(x, y), 1);
    // Next to the step at 40 the large window is not blank, the pixel's surroundings are.
    for (int x = 41; x < 60; ++x) EXPECT_EQ(weak.at(x, y), 1);
  }
}

TEST(StereoMatcher, MedianRemovesASpikeAndKeepsAnIsolatedPixel) {
  ImagePlane<float> disparity(7, 7, 5.0F);
  disparity.at(3, 3) = 50.0F;
  EXPECT_EQ(median_filtered(disparity).at(3, 3), 5.0F);
  std::ranges::fill(disparity.values, std::numeric_limits<float>::quiet_NaN());
  disparity.at(3, 3) = 50.0F;
  EXPECT_EQ(median_filtered(disparity).at(3, 3), 50.0F);
}

TEST(StereoMatcher, SmallIslandsGoAndAGentleSlopeIsOneSegment) {
  ImagePlane<float> disparity(20, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) disparity.at(x, y) = 0.9F * static_cast<float>(x);
  }
  for (int y = 2; y < 5; ++y) disparity.at(4, y) = 100.0F;
  remove_small_segments(disparity, 10);
  EXPECT_TRUE(std::isnan(disparity.at(4, 3)));
  EXPECT_EQ(std::ranges::count_if(disparity.values, [](float d) { return std::isnan(d); }), 3);
}

TEST(StereoMatcher, HalvingTheImagesHalvesTheDisparityIndex) {
  const RectifiedImages half = half_size(textured_pair(160, 80, 33, [](int, int) { return 14.0; }));
  EXPECT_EQ(half.num_disparities, 17);
  EXPECT_EQ(half.right.width, half.left.width + 16);
  const ImagePlane<float> found = match_semi_globally(half, full_ranges(half), {});
  EXPECT_NEAR(found.at(40, 20), 7.0, 0.1);
}

}  // namespace
}  // namespace hybridfusion
