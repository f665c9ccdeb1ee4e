#include "features.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// Smooth blobs of random place, size and grey value.
Image8 blobs(int width, int height, int count) {
  Image8 image{.width = width, .height = height, .channels = 3};
  std::vector<double> gray(static_cast<std::size_t>(width * height), 128.0);
  Random random(4, "test/blobs");
  for (int i = 0; i < count; ++i) {
    const double cx = random.uniform(0, width);
    const double cy = random.uniform(0, height);
    const double sigma = random.uniform(1.5, 4.0);
    const double height_gray = random.uniform(-70, 70);
    for (int y = std::max(0, static_cast<int>(cy - 12));
         y < std::min(height, static_cast<int>(cy + 13));
         ++y) {
      for (int x = std::max(0, static_cast<int>(cx - 12));
           x < std::min(width, static_cast<int>(cx + 13));
           ++x) {
        const double r2 = (x - cx) * (x - cx) + (y - cy) * (y - cy);
        gray[static_cast<std::size_t>(y * width + x)] +=
            height_gray * std::exp(-r2 / (2 * sigma * sigma));
      }
    }
  }
  for (const double g : gray) {
    const auto value = static_cast<std::uint8_t>(std::clamp(g, 0.0, 255.0));
    image.pixels.insert(image.pixels.end(), 3, value);
  }
  return image;
}

Image8 turned_by_180(const Image8& image) {
  Image8 turned = image;
  const std::size_t count = image.pixels.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      turned.pixels[3 * i + c] = image.pixels[3 * (count - 1 - i) + c];
    }
  }
  return turned;
}

TEST(ExtractFeatures, PixelCentresSurviveTurningThePhotoUpsideDown) {
  // First centre at (0, 0): a point at x is at width - 1 - x in the turned photo. Half a pixel of
  // error in the convention, or a quarter in the detector, shows as a mean offset.
  const Image8 image = blobs(320, 240, 150);
  const auto upright = extract_features(image, {});
  const auto turned = extract_features(turned_by_180(image), {});
  ASSERT_TRUE(upright && turned);
  std::vector<double> dx;
  std::vector<double> dy;
  for (const Eigen::Vector2f& a : upright->pixels) {
    for (const Eigen::Vector2f& b : turned->pixels) {
      const Eigen::Vector2f gap = a - Eigen::Vector2f(319.0F - b.x(), 239.0F - b.y());
      if (gap.norm() < 1.0F) {
        dx.push_back(gap.x());
        dy.push_back(gap.y());
      }
    }
  }
  ASSERT_GT(dx.size(), 50U);
  std::ranges::sort(dx);
  std::ranges::sort(dy);
  EXPECT_NEAR(dx[dx.size() / 2], 0.0, 0.05);
  EXPECT_NEAR(dy[dy.size() / 2], 0.0, 0.05);
}

TEST(ExtractFeatures, KeypointsOfAReducedPhotoAreInItsOwnPixels) {
  const Image8 image = blobs(320, 240, 150);
  const auto full = extract_features(image, {});
  const auto reduced = extract_features(image, {.max_size_px = 200});
  ASSERT_TRUE(full && reduced);
  std::vector<double> gaps;
  for (const Eigen::Vector2f& a : reduced->pixels) {
    for (const Eigen::Vector2f& b : full->pixels) {
      if ((a - b).norm() < 2.0F) gaps.push_back((a - b).x());
    }
  }
  ASSERT_GT(gaps.size(), 50U);
  std::ranges::sort(gaps);
  EXPECT_NEAR(gaps[gaps.size() / 2], 0.0, 0.1);
}

/// Round marks on a grid with known centres, far enough apart not to disturb each other.
Image8 marks(int width, int height, std::vector<Eigen::Vector2d>& centres) {
  constexpr int kStep_px = 40;
  constexpr double kSigma_px = 4.0;
  Image8 image{.width = width, .height = height, .channels = 3};
  std::vector<double> gray(static_cast<std::size_t>(width * height), 60.0);
  Random random(9, "test/marks");
  for (int cy = kStep_px; cy + kStep_px / 2 < height; cy += kStep_px) {
    for (int cx = kStep_px; cx + kStep_px / 2 < width; cx += kStep_px) {
      const Eigen::Vector2d centre(cx + random.uniform(-0.5, 0.5), cy + random.uniform(-0.5, 0.5));
      centres.push_back(centre);
      for (int y = cy - 19; y < std::min(cy + 20, height); ++y) {
        for (int x = cx - 19; x < std::min(cx + 20, width); ++x) {
          const double r2 = (Eigen::Vector2d(x, y) - centre).squaredNorm();
          gray[static_cast<std::size_t>(y * width + x)] +=
              150.0 * std::exp(-r2 / (2 * kSigma_px * kSigma_px));
        }
      }
    }
  }
  for (const double g : gray) {
    image.pixels.insert(
        image.pixels.end(), 3, static_cast<std::uint8_t>(std::lround(std::min(g, 255.0))));
  }
  return image;
}

TEST(ExtractFeatures, MarksAreFoundWhereTheyAreToTwoHundredthsOfAPixel) {
  struct Case {
    int width;
    int height;
    int max_size_px;
  };
  // The rows of the reduced ones do not divide: 611 -> 458.25, 613 -> 383.125.
  for (const Case& each : {Case{800, 600, 4000}, Case{800, 611, 600}, Case{800, 613, 500}}) {
    std::vector<Eigen::Vector2d> centres;
    const Image8 image = marks(each.width, each.height, centres);
    const auto features = extract_features(image, {.max_size_px = each.max_size_px});
    ASSERT_TRUE(features);
    Eigen::Vector2d upper = Eigen::Vector2d::Zero();  // mean gap in the upper and the lower half
    Eigen::Vector2d lower = Eigen::Vector2d::Zero();
    double num_upper = 0.0;
    double num_lower = 0.0;
    for (const Eigen::Vector2d& centre : centres) {
      Eigen::Vector2d nearest(9.0, 9.0);
      for (const Eigen::Vector2f& at : features->pixels) {
        const Eigen::Vector2d gap = at.cast<double>() - centre;
        if (gap.norm() < nearest.norm()) nearest = gap;
      }
      if (nearest.norm() > 1.0) continue;
      (centre.y() < 0.5 * each.height ? upper : lower) += nearest;
      (centre.y() < 0.5 * each.height ? num_upper : num_lower) += 1.0;
    }
    ASSERT_GT(std::min(num_upper, num_lower), 50.0) << each.height;
    EXPECT_LT((upper / num_upper).norm(), 0.02) << each.height;
    EXPECT_LT((lower / num_lower).norm(), 0.02) << each.height;
  }
}

TEST(ExtractFeatures, CapIsSpreadOverThePhoto) {
  const Image8 image = blobs(320, 240, 400);
  const auto all = extract_features(image, {});
  const auto some = extract_features(image, {.max_keypoints = 150});
  ASSERT_TRUE(all && some);
  ASSERT_GT(all->size(), 300U);
  EXPECT_GE(some->size(), 150U);
  EXPECT_LT(some->size(), 230U);
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const auto count = std::ranges::count_if(some->pixels, [&](const Eigen::Vector2f& p) {
      return (p.x() > 160.0F) == (quadrant % 2 == 1) && (p.y() > 120.0F) == (quadrant / 2 == 1);
    });
    EXPECT_GT(count, 25);
  }
}

TEST(ExtractFeatures, BlankPhotoHasNone) {
  Image8 image{.width = 200, .height = 100, .channels = 3};
  image.pixels.assign(200 * 100 * 3, 90);
  const auto features = extract_features(image, {});
  ASSERT_TRUE(features);
  EXPECT_EQ(features->size(), 0U);
}

TEST(ExtractFeatures, GreyInputIsRefused) {
  Image8 image{.width = 200, .height = 100, .channels = 1};
  image.pixels.assign(200 * 100, 90);
  EXPECT_EQ(extract_features(image, {}).error().code, ErrorCode::kInsufficient);
}

}  // namespace
}  // namespace hybridfusion
