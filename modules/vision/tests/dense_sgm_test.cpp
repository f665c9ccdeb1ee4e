#include "dense/census.hpp"
#include "rectified_pairs.hpp"

#include <hybridfusion/core/random.hpp>

#include <bit>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

using Grey = ImagePlane<std::uint8_t>;
using testing::blank_pair;

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

}  // namespace
}  // namespace hybridfusion
