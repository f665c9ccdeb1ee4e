#include "matching.hpp"

#include <hybridfusion/core/random.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hybridfusion {
namespace {

FeatureSet random_features(std::size_t count, std::uint64_t seed) {
  Random random(seed, "test/matching");
  FeatureSet features;
  for (std::size_t i = 0; i < count; ++i) {
    features.pixels.emplace_back(static_cast<float>(i), 0.0F);
    for (std::size_t k = 0; k < kDescriptorSize; ++k) {
      // Sparse like real descriptors.
      const double value = std::max(0.0, 60.0 * random.normal());
      features.descriptors.push_back(static_cast<std::uint8_t>(std::min(255.0, value)));
    }
  }
  return features;
}

/// A noisy copy in reverse order.
FeatureSet noisy_copy(const FeatureSet& features, std::uint64_t seed) {
  Random random(seed, "test/noise");
  FeatureSet copy;
  for (std::size_t i = features.size(); i-- > 0;) {
    copy.pixels.push_back(features.pixels[i]);
    for (std::size_t k = 0; k < kDescriptorSize; ++k) {
      const double value = features.descriptors[i * kDescriptorSize + k] + 12.0 * random.normal();
      copy.descriptors.push_back(static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)));
    }
  }
  return copy;
}

/// The textbook: every distance, nearest two both ways.
std::vector<Match> brute_force(const FeatureSet& a, const FeatureSet& b, double ratio) {
  const auto unit = [](const FeatureSet& f, std::size_t i) {
    Eigen::Matrix<double, kDescriptorSize, 1> v;
    for (std::size_t k = 0; k < kDescriptorSize; ++k) {
      v[static_cast<Eigen::Index>(k)] = f.descriptors[i * kDescriptorSize + k];
    }
    return v.normalized().eval();
  };
  Eigen::MatrixXd distance(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      distance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (unit(a, i) - unit(b, j)).norm();
    }
  }
  std::vector<Match> matches;
  for (Eigen::Index i = 0; i < distance.rows(); ++i) {
    Eigen::Index j = 0;
    const double nearest = distance.row(i).minCoeff(&j);
    double second = 1e9;
    for (Eigen::Index k = 0; k < distance.cols(); ++k) {
      if (k != j) second = std::min(second, distance(i, k));
    }
    Eigen::Index back = 0;
    distance.col(j).minCoeff(&back);
    if (back != i || nearest >= ratio * second || nearest > 2.0 * std::sin(0.35)) continue;
    matches.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)});
  }
  return matches;
}

TEST(MatchFeatures, EqualsBruteForceAcrossBlockBorders) {
  // More than one block in both directions, and no multiple of a lane.
  const FeatureSet a = random_features(301, 1);
  FeatureSet b = noisy_copy(a, 2);
  const FeatureSet distractors = random_features(1050, 3);
  b.pixels.insert(b.pixels.end(), distractors.pixels.begin(), distractors.pixels.end());
  b.descriptors.insert(
      b.descriptors.end(), distractors.descriptors.begin(), distractors.descriptors.end());
  const auto expected = brute_force(a, b, 0.8);
  const auto actual = match_features(a, b, 0.8);
  ASSERT_GT(expected.size(), 250U);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < actual.size(); ++k) {
    EXPECT_EQ(actual[k].first, expected[k].first);
    EXPECT_EQ(actual[k].second, expected[k].second);
  }
}

TEST(MatchFeatures, RepeatedDescriptorHasNoUniqueMatch) {
  FeatureSet a = random_features(40, 5);
  FeatureSet b = noisy_copy(a, 6);
  // The last feature of b once more: its partner in a has two equal candidates now.
  const std::vector<std::uint8_t> last(b.descriptors.end() - kDescriptorSize, b.descriptors.end());
  b.pixels.push_back(b.pixels.back());
  b.descriptors.insert(b.descriptors.end(), last.begin(), last.end());
  for (const Match& match : match_features(a, b, 0.8)) EXPECT_NE(match.first, 0U);
}

TEST(MatchFeatures, EmptySetsGiveNoMatches) {
  EXPECT_TRUE(match_features({}, random_features(5, 1), 0.8).empty());
  EXPECT_TRUE(match_features(random_features(5, 1), {}, 0.8).empty());
}

}  // namespace
}  // namespace hybridfusion
