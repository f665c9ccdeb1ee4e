#include <hybridfusion/core/random.hpp>
#include <hybridfusion/geometry/kd_tree.hpp>
#include <hybridfusion/registration/gap_interpolation.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

/// Height of a gently rolling ground.
float rolling(float x, float y) {
  return 0.3F * std::sin(0.5F * x) + 0.2F * std::cos(0.4F * y);
}

/// Points of the rolling ground in [0, 6] x [0, 6], one per `step` m, but for a disc in the middle.
PointCloud ground(float step, float hole_radius_m) {
  PointCloud cloud;
  for (float x = 0.0F; x <= 6.0F; x += step) {
    for (float y = 0.0F; y <= 6.0F; y += step) {
      if (std::hypot(x - 3.0F, y - 3.0F) < hole_radius_m) continue;
      cloud.points.emplace_back(x, y, rolling(x, y));
    }
  }
  cloud.sigmas_m.assign(cloud.size(), 0.01F);
  cloud.colors.assign(cloud.size(), Rgb8{100, 150, 200});
  return cloud;
}

float nearest_m(const PointCloud& cloud, const Eigen::Vector3f& at) {
  float least = 1e9F;
  for (const Eigen::Vector3f& p : cloud.points) least = std::min(least, (p - at).norm());
  return least;
}

TEST(GapInterpolation, ASlitThroughALargeSurfaceIsFilledFromEndToEnd) {
  // More starts than one slice takes, so that slices meet along the slit.
  constexpr float kLength_m = 180.0F;
  PointCloud cloud;
  for (int i = 0; i <= 1200; ++i) {
    for (int k = 0; k <= 160; ++k) {
      const float y = 0.15F * static_cast<float>(k);
      if (std::abs(y - 12.0F) < 0.17F) continue;
      cloud.points.emplace_back(0.15F * static_cast<float>(i), y, 0.0F);
    }
  }
  const PointCloud added = interpolate_gaps(cloud);
  std::vector<int> filled(static_cast<std::size_t>(kLength_m), 0);
  for (const Eigen::Vector3f& p : added.points) {
    if (std::abs(p.y() - 12.0F) < 0.3F) ++filled[static_cast<std::size_t>(std::min(p.x(), 179.0F))];
  }
  EXPECT_GT(*std::min_element(filled.begin() + 1, filled.end() - 1), 3);
  const KdTree tree(added.points);
  for (std::size_t i = 0; i < added.size(); ++i) {
    std::vector<Neighbor> two;
    tree.nearest(added.points[i], 2, two);
    EXPECT_GT(two.back().squared_distance_m2, 0.0F);
  }
}

TEST(GapInterpolation, ANarrowGapOfASurfaceIsFilledOnTheSurface) {
  const PointCloud cloud = ground(0.1F, 0.25F);
  const PointCloud added = interpolate_gaps(cloud);
  ASSERT_GT(added.size(), 5U);
  EXPECT_LT(nearest_m(added, {3.0F, 3.0F, rolling(3.0F, 3.0F)}), 0.1F);
  for (std::size_t i = 0; i < added.size(); ++i) {
    const Eigen::Vector3f& p = added.points[i];
    EXPECT_LT(std::abs(p.z() - rolling(p.x(), p.y())), 0.01F);
    EXPECT_GE(nearest_m(cloud, p), 0.0999F) << "measured points are enough there";
    EXPECT_EQ(added.sources[i], PointSource::kInterpolated);
    EXPECT_GE(added.sigmas_m[i], 0.01F) << "no better than what it comes from";
    EXPECT_EQ(added.colors[i], (Rgb8{100, 150, 200}));
  }
}

TEST(GapInterpolation, AWideHoleStaysOpen) {
  const PointCloud added = interpolate_gaps(ground(0.1F, 1.2F));
  for (const Eigen::Vector3f& p : added.points) {
    EXPECT_GT(std::hypot(p.x() - 3.0F, p.y() - 3.0F), 0.8F);
  }
}

TEST(GapInterpolation, NothingIsAddedBeyondTheRimOfASurface) {
  const PointCloud added = interpolate_gaps(ground(0.15F, 0.0F));
  ASSERT_GT(added.size(), 100U);
  for (const Eigen::Vector3f& p : added.points) {
    EXPECT_GT(std::min(p.x(), p.y()), -0.02F);
    EXPECT_LT(std::max(p.x(), p.y()), 6.02F);
  }
}

TEST(GapInterpolation, ADenseSurfaceGetsNoPoints) {
  EXPECT_TRUE(interpolate_gaps(ground(0.05F, 0.0F)).empty());
}

TEST(GapInterpolation, TwoWallsApartAreNotJoined) {
  PointCloud cloud;
  for (float y = 0.0F; y < 4.0F; y += 0.15F) {
    for (float z = 0.0F; z < 3.0F; z += 0.15F) {
      cloud.points.emplace_back(0.0F, y, z);
      cloud.points.emplace_back(0.6F, y, z);
    }
  }
  for (const Eigen::Vector3f& p : interpolate_gaps(cloud).points) {
    EXPECT_LT(std::min(std::abs(p.x()), std::abs(p.x() - 0.6F)), 0.01F);
  }
}

TEST(GapInterpolation, ARoughPlaceStaysOpenOrSaysSoBySigma) {
  const std::size_t smooth = interpolate_gaps(ground(0.2F, 0.0F)).size();
  PointCloud rough = ground(0.2F, 0.0F);
  Random random(3, "rough ground");
  for (Eigen::Vector3f& p : rough.points) p.z() += static_cast<float>(random.uniform(-0.3, 0.3));
  InterpolationOptions strict;
  strict.max_roughness_m = 0.05;
  EXPECT_LT(interpolate_gaps(rough, strict).size(), smooth / 10);
  const PointCloud added = interpolate_gaps(rough);
  ASSERT_GT(added.size(), 100U);
  std::vector<float> ratios;
  for (std::size_t i = 0; i < added.size(); ++i) {
    const Eigen::Vector3f& p = added.points[i];
    ratios.push_back(std::abs(p.z() - rolling(p.x(), p.y())) / added.sigmas_m[i]);
  }
  std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
  EXPECT_LT(ratios[ratios.size() / 2], 1.5F);
}

TEST(GapInterpolation, EveryChannelIsCarriedAndTheResultDoesNotDependOnThreads) {
  PointCloud cloud = ground(0.15F, 0.3F);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.intensities.push_back(static_cast<float>(i % 7));
  }
  RunContext one;
  one.num_threads = 1;
  RunContext three;
  three.num_threads = 3;
  const PointCloud a = interpolate_gaps(cloud, {}, one);
  const PointCloud b = interpolate_gaps(cloud, {}, three);
  EXPECT_TRUE(validate(a));
  ASSERT_EQ(a.size(), b.size());
  ASSERT_EQ(a.intensities.size(), a.size());
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.sigmas_m, b.sigmas_m);
  EXPECT_EQ(a.colors, b.colors);
}

TEST(GapInterpolation, EmptyTinyAndFarCloudsGetNothing) {
  EXPECT_TRUE(interpolate_gaps({}).empty());
  PointCloud few;
  for (int i = 0; i < 4; ++i) few.points.emplace_back(0.1F * static_cast<float>(i), 0.0F, 0.0F);
  EXPECT_TRUE(interpolate_gaps(few).empty());
  PointCloud far = ground(0.15F, 0.0F);
  for (Eigen::Vector3f& p : far.points) p.x() += 1e9F;
  EXPECT_TRUE(interpolate_gaps(far).empty());
}

}  // namespace
}  // namespace hybridfusion
