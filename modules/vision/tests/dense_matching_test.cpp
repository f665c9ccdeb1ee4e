#include "dense/census.hpp"
#include "dense/semi_global_matching.hpp"
#include "dense/stereo_matcher.hpp"
#include "dense/texture_mask.hpp"
#include "dense_box_scene.hpp"

#include <hybridfusion/core/random.hpp>

#include <bit>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Grey = ImagePlane<std::uint8_t>;

RectifiedImages blank_pair(int width, int height, int num_disparities) {
  const int right_width = width + num_disparities - 1;
  return {.left = {width, height, 128},
          .right = {right_width, height, 128},
          .left_mask = {width, height, 255},
          .right_mask = {right_width, height, 255},
          .num_disparities = num_disparities};
}

/// A textured pair whose left pixel (x, y) has disparity index k(x, y), sampled without error.
template <class Disparity>
RectifiedImages textured_pair(int width, int height, int num_disparities, Disparity&& k) {
  RectifiedImages pair = blank_pair(width, height, num_disparities);
  const auto grey = [](double u, double v) {
    return static_cast<std::uint8_t>(std::lround(testing::texture(u, v, 4, 4.0)));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < pair.right.width; ++x) pair.right.at(x, y) = grey(x, y);
    for (int x = 0; x < width; ++x) {
      pair.left.at(x, y) = grey(x - k(x, y) + num_disparities - 1, y);
    }
  }
  return pair;
}

RectifiedImages random_pair(int width, int height, int num_disparities) {
  Random random(5, "matching test");
  RectifiedImages pair = blank_pair(width, height, num_disparities);
  for (std::uint8_t& v : pair.right.values) v = static_cast<std::uint8_t>(random.index(256));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int k = 3 + (x > width / 2 ? 4 : 0);  // two surfaces
      const int noise = static_cast<int>(random.index(9)) - 4;
      pair.left.at(x, y) = static_cast<std::uint8_t>(
          std::clamp(pair.right.at(x - k + num_disparities - 1, y) + noise, 0, 255));
    }
  }
  for (int y = 3; y < 6; ++y) pair.left_mask.at(width / 3, y) = 0;
  for (int y = 0; y < height; ++y) pair.right_mask.at(pair.right.width - 1, y) = 0;
  return pair;
}

/// Semi-global matching as the paper writes it, one number at a time.
class Textbook {
 public:
  Textbook(const RectifiedImages& images, const StereoOptions& options)
      : images_(images), options_(options) {
    const auto left = census_transform(images.left);
    const auto right = census_transform(images.right);
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        for (int k = 0; k < count(); ++k) {
          const int c = x - k + count() - 1;
          costs_.push_back(
              images.right_mask.at(c, y) == 0 ? 31 : std::popcount(left.at(x, y) ^ right.at(c, y)));
        }
      }
    }
    sums_.assign(costs_.size(), 0);
    for (const int dx : {-1, 0, 1}) {
      for (const int dy : {-1, 0, 1}) {
        const bool diagonal = dx != 0 && dy != 0;
        if ((dx != 0 || dy != 0) && (options.diagonal_paths || !diagonal)) add_paths(dx, dy);
      }
    }
  }

  [[nodiscard]] ImagePlane<float> disparity() const {
    ImagePlane<float> result(width(), height(), std::numeric_limits<float>::quiet_NaN());
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) {
        if (images_.left_mask.at(x, y) != 0) result.at(x, y) = best(x, y);
      }
    }
    return result;
  }

 private:
  [[nodiscard]] int width() const { return images_.left.width; }
  [[nodiscard]] int height() const { return images_.left.height; }
  [[nodiscard]] int count() const { return images_.num_disparities; }
  [[nodiscard]] std::size_t at(int x, int y, int k) const {
    return (images_.left.offset(x, y)) * static_cast<std::size_t>(count()) +
           static_cast<std::size_t>(k);
  }
  [[nodiscard]] bool valid(int x, int y) const {
    return images_.left.contains(x, y) && images_.left_mask.at(x, y) != 0;
  }

  // L(p, d) by recursion along one direction, memoised from the border inwards.
  void add_paths(int dx, int dy) {
    std::vector<int> path(costs_.size(), 0);
    for (int i = 0; i < height(); ++i) {
      for (int j = 0; j < width(); ++j) {
        const int x = dx < 0 ? width() - 1 - j : j;
        const int y = dy < 0 ? height() - 1 - i : i;
        if (!valid(x, y)) continue;
        for (int k = 0; k < count(); ++k) {
          path[at(x, y, k)] = costs_[at(x, y, k)] + carried(path, x, y, x - dx, y - dy, k);
          sums_[at(x, y, k)] += path[at(x, y, k)];
        }
      }
    }
  }

  [[nodiscard]] int carried(
      const std::vector<int>& path, int x, int y, int from_x, int from_y, int k) const {
    if (!valid(from_x, from_y)) return 0;
    const auto* before = path.data() + at(from_x, from_y, 0);
    const int least = *std::min_element(before, before + count());
    const int step = std::abs(images_.left.at(x, y) - images_.left.at(from_x, from_y));
    const int large =
        std::max(options_.smoothness_small + 1, options_.smoothness_large * 16 / (16 + step));
    int cheapest = std::min(before[k], least + large);
    if (k > 0) cheapest = std::min(cheapest, before[k - 1] + options_.smoothness_small);
    if (k + 1 < count()) cheapest = std::min(cheapest, before[k + 1] + options_.smoothness_small);
    return cheapest - least;
  }

  [[nodiscard]] float best(int x, int y) const {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    const int* sum = sums_.data() + at(x, y, 0);
    const int k = static_cast<int>(std::min_element(sum, sum + count()) - sum);
    if (k == 0 || k == count() - 1) return kNone;
    for (int other = 0; other < count(); ++other) {
      if (std::abs(other - k) > 1 && sum[other] < (1.0 + options_.uniqueness) * sum[k])
        return kNone;
    }
    const auto rise = static_cast<float>(std::max(sum[k - 1], sum[k + 1]) - sum[k]);
    const float offset =
        rise > 0.0F ? 0.5F * static_cast<float>(sum[k - 1] - sum[k + 1]) / rise : 0.0F;
    const float result = static_cast<float>(k) + offset;
    const int column = x - static_cast<int>(std::lround(result)) + count() - 1;
    if (!images_.right.contains(column, y) || images_.right_mask.at(column, y) == 0) return kNone;
    int from_right = -1;
    for (int u = 0; u < width(); ++u) {
      const int d = u - column + count() - 1;
      if (d < 0 || d >= count() || !valid(u, y)) continue;
      if (from_right < 0 ||
          sums_[at(u, y, d)] < sums_[at(column + from_right - count() + 1, y, from_right)]) {
        from_right = d;
      }
    }
    return std::abs(static_cast<float>(from_right) - result) <= options_.max_left_right_px + 0.5
               ? result
               : kNone;
  }

  const RectifiedImages& images_;
  const StereoOptions& options_;
  std::vector<int> costs_;
  std::vector<int> sums_;
};

TEST(SemiGlobalMatching, EqualsTheTextbookOnSmallNoisyImages) {
  const RectifiedImages pair = random_pair(50, 22, 37);  // more candidates than two vectors hold
  for (const bool diagonal : {false, true}) {
    const int small = diagonal ? 3 : 10;
    const StereoOptions options{
        .diagonal_paths = diagonal, .smoothness_small = small, .smoothness_large = 6 * small};
    const ImagePlane<float> fast = match_semi_globally(pair, full_ranges(pair), options);
    const ImagePlane<float> slow = Textbook(pair, options).disparity();
    int valid = 0;
    for (std::size_t i = 0; i < fast.values.size(); ++i) {
      EXPECT_EQ(std::isnan(fast.values[i]), std::isnan(slow.values[i])) << i;
      if (std::isnan(fast.values[i]) || std::isnan(slow.values[i])) continue;
      EXPECT_FLOAT_EQ(fast.values[i], slow.values[i]) << i;
      ++valid;
    }
    EXPECT_GT(valid, 300);  // the comparison is not about nothing
  }
}

TEST(SemiGlobalMatching, StripsOfRowsGiveTheSameBytesAsOnePiece) {
  const RectifiedImages pair = random_pair(400, 120, 61);
  const DisparityRanges ranges = full_ranges(pair);  // 8.8 MiB of costs
  for (const bool diagonal : {false, true}) {
    const StereoOptions whole{.diagonal_paths = diagonal};
    const StereoOptions strips{.diagonal_paths = diagonal, .max_volume_mib = 1};
    const auto a = match_semi_globally(pair, ranges, whole);
    const auto b = match_semi_globally(pair, ranges, strips);
    EXPECT_GT(std::ranges::count_if(a.values, [](float k) { return !std::isnan(k); }), 30000);
    EXPECT_EQ(std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)), 0);
  }
}

TEST(SemiGlobalMatching, NarrowRangesThatJumpGiveTheDisparityInsideThem) {
  const RectifiedImages pair = random_pair(80, 40, 61);
  DisparityRanges ranges = full_ranges(pair);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) {
      if (ranges.count.at(x, y) == 0) continue;
      // The truth is 3 or 7; every other pixel looks near, some far above it.
      ranges.low.at(x, y) = static_cast<std::int16_t>((x + y) % 5 == 4 ? 44 : (x + y) % 2);
      ranges.count.at(x, y) = static_cast<std::int16_t>((x + y) % 5 == 4 ? 17 : 11 + x % 7);
    }
  }
  const auto found = match_semi_globally(pair, ranges, {});
  int right = 0;
  int wrong = 0;
  for (int y = 4; y < 36; ++y) {
    for (int x = 6; x < 74; ++x) {
      if (std::isnan(found.at(x, y)) || std::abs(x - 40) < 6 || (x + y) % 5 == 4) continue;
      (std::abs(found.at(x, y) - (x > 40 ? 7.0F : 3.0F)) < 0.6F ? right : wrong) += 1;
    }
  }
  EXPECT_GT(right, 1200);
  EXPECT_LT(wrong, 0.01 * right);
}

TEST(Census, ComparesEveryNeighbourWithTheCentreAndIgnoresGainAndOffset) {
  Grey image(20, 15);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.at(x, y) = static_cast<std::uint8_t>(100.0 * testing::lattice(x, y, 1));
    }
  }
  const auto codes = census_transform(image);
  std::uint64_t by_hand = 0;
  for (int v = 7 - 3; v <= 7 + 3; ++v) {
    for (int u = 9 - 4; u <= 9 + 4; ++u) {
      if (u == 9 && v == 7) continue;
      by_hand = 2 * by_hand + (image.at(u, v) < image.at(9, 7) ? 1 : 0);
    }
  }
  EXPECT_EQ(codes.at(9, 7), by_hand);
  for (std::uint8_t& v : image.values) v = static_cast<std::uint8_t>(2 * v + 13);
  EXPECT_EQ(census_transform(image).values, codes.values);
}

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
